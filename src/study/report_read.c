/* Reads a run's report. */
#include "study/report_read.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

double report_number(const struct json *report, const char *path)
{
    char key[64];
    int node = 0;
    for (size_t n; *path; path += n + (path[n] == '.')) {
        n = strcspn(path, ".");
        snprintf(key, sizeof key, "%.*s", (int)n, path);
        if (report->nodes[node].kind != JSON_OBJECT ||
            (node = json_member(report, node, key)) < 0)
            return (double)NAN;
    }
    return report->nodes[node].kind == JSON_NUMBER
               ? strtod(report->text + report->nodes[node].start, NULL) : (double)NAN;
}

void report_last_hash(const struct json *report, char hash[17])
{
    int frames = json_member(report, 0, "frames");
    hash[0] = 0;
    if (frames < 0 || report->nodes[frames].kind != JSON_ARRAY)
        return;
    for (int k = 0, node = frames + 1; k < report->nodes[frames].size;
         k++, node = report->nodes[node].next) {
        int state = json_member(report, node, "state");
        if (state >= 0)
            json_string(report, state, hash, 17);
    }
}
