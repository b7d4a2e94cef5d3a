/* Counts verdicts, and hands them to each sink. */
#include "compare/record.h"

enum status record_add(struct record *record, const struct sink_row *row, const char *path,
                       struct error *e)
{
    struct sink *sink;
    if (row->open(&sink, record->comparison, path, e))
        return e->status;
    record->sinks[record->sink_count].row = row;
    record->sinks[record->sink_count++].sink = sink;
    return STATUS_OK;
}

enum status record_frame(struct record *record, const struct verdict *verdict, struct error *e)
{
    record->tally.frames++;
    record->tally.failed += !verdict_passes(verdict->state);
    record->tally.count[verdict->state]++;
    for (size_t i = 0; i < record->sink_count; i++)
        if (record->sinks[i].row->frame(record->sinks[i].sink, verdict, e))
            return e->status;
    return STATUS_OK;
}

enum status record_close(struct record *record, bool keep, struct error *e)
{
    struct error closing;
    enum status status = STATUS_OK;
    for (size_t i = 0; i < record->sink_count; i++)
        if (record->sinks[i].row->close(record->sinks[i].sink, &record->tally, keep, &closing) &&
            keep && !status) {
            *e = closing;
            status = closing.status;
        }
    record->sink_count = 0;
    return status;
}
