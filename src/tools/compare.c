/* sph-render compare: are two pictures the same, by how much not, and where. */
#include "tools/compare.h"

#include "base/image.h"

#include <argp.h>
#include <errno.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

enum { EXIT_SAME = 0, EXIT_DIFFERENT = 1, EXIT_ERROR = 2 };
enum { DIFF_GAIN = 16 }; /* one level of difference shows as 16 */

enum { OPTION_MAX_CHANNEL = 0x100, OPTION_MAX_FRACTION, OPTION_DIFF, OPTION_HELP, OPTION_USAGE };

struct request {
    const char *paths[2];
    int path_count;
    const char *diff;
    double max_channel;  /* levels of 0..255 that count as the same */
    double max_fraction; /* of pixels that may differ by more */
    bool help;
};

/* A metric measures two pictures of one size, and says whether its limit is kept. */
struct metric {
    const char *name;
    const char *unit;
    double (*measure)(const struct image *a, const struct image *b, const struct request *request);
    double (*limit)(const struct request *request); /* NULL: for information only */
};

/* The largest difference of a pixel's channels, 0..255. */
static int pixel_difference(const uint8_t *a, const uint8_t *b)
{
    int most = 0;
    for (int k = 0; k < 4; k++) {
        int difference = abs(a[k] - b[k]);
        most = difference > most ? difference : most;
    }
    return most;
}

static size_t pixel_count(const struct image *image)
{
    return (size_t)image->width * (size_t)image->height;
}

static double channel_measure(const struct image *a, const struct image *b,
                              const struct request *request)
{
    int most = 0;
    (void)request;
    for (size_t i = 0; i < pixel_count(a); i++) {
        int difference = pixel_difference(a->rgba + 4 * i, b->rgba + 4 * i);
        most = difference > most ? difference : most;
    }
    return most;
}

static double fraction_measure(const struct image *a, const struct image *b,
                               const struct request *request)
{
    size_t differing = 0;
    for (size_t i = 0; i < pixel_count(a); i++)
        differing += pixel_difference(a->rgba + 4 * i, b->rgba + 4 * i) > request->max_channel;
    return (double)differing / (double)pixel_count(a);
}

static double fraction_limit(const struct request *request)
{
    return request->max_fraction;
}

static const struct metric metrics[] = {
    {"max channel difference", "of 255", channel_measure, NULL},
    {"pixels over --max-channel", "of 1", fraction_measure, fraction_limit},
};

/* Black where the pictures agree; differences per channel, amplified. */
static enum status diff_write(const struct image *a, const struct image *b, const char *path,
                              struct error *e)
{
    struct image diff = {0};
    enum status status = image_create(&diff, a->width, a->height, e);
    if (status != STATUS_OK)
        return status;
    for (size_t i = 0; i < 4 * pixel_count(a); i++) {
        int level = abs(a->rgba[i] - b->rgba[i]) * DIFF_GAIN;
        diff.rgba[i] = (uint8_t)(i % 4 == 3 ? 255 : level < 255 ? level : 255);
    }
    status = image_write_png(&diff, path, e);
    image_free(&diff);
    return status;
}

static int judge(const struct image *a, const struct image *b, const struct request *request)
{
    bool same = true;
    for (size_t i = 0; i < sizeof metrics / sizeof metrics[0]; i++) {
        double value = metrics[i].measure(a, b, request);
        printf("%-26s %.6g %s", metrics[i].name, value, metrics[i].unit);
        if (metrics[i].limit) {
            double limit = metrics[i].limit(request);
            printf(" (limit %g)", limit);
            same = same && value <= limit;
        }
        putchar('\n');
    }
    puts(same ? "same" : "different");
    return same ? EXIT_SAME : EXIT_DIFFERENT;
}

static int compare(const struct request *request)
{
    struct image a = {0}, b = {0};
    struct error e;
    int result = EXIT_ERROR;
    if (image_read_png(&a, request->paths[0], &e) != STATUS_OK ||
        image_read_png(&b, request->paths[1], &e) != STATUS_OK)
        goto cleanup;
    printf("%-26s %d x %d, %d x %d\n", "size", a.width, a.height, b.width, b.height);
    if (a.width != b.width || a.height != b.height) {
        puts("different: sizes");
        result = EXIT_DIFFERENT;
        goto cleanup;
    }
    if (request->diff && diff_write(&a, &b, request->diff, &e) != STATUS_OK)
        goto cleanup;
    result = judge(&a, &b, request);
cleanup:
    if (result == EXIT_ERROR)
        fprintf(stderr, "sph-render compare: %s\n", e.text);
    image_free(&a);
    image_free(&b);
    return result;
}

/* A number of 0 to most; EINVAL with a message otherwise. */
static error_t number_read(const struct argp_state *state, const char *option, const char *text,
                           double most, double *value)
{
    char *end;
    *value = strtod(text, &end);
    if (end != text && *end == '\0' && *value >= 0 && *value <= most)
        return 0;
    fprintf(stderr, "%s: --%s needs a number from 0 to %g, not \"%s\"\n", state->name, option,
            most, text);
    return EINVAL;
}

static error_t option_read(int key, char *text, struct argp_state *state)
{
    struct request *request = state->input;
    switch (key) {
    case OPTION_MAX_CHANNEL:
        return number_read(state, "max-channel", text, 255, &request->max_channel);
    case OPTION_MAX_FRACTION:
        return number_read(state, "max-fraction", text, 1, &request->max_fraction);
    case OPTION_DIFF:
        request->diff = text;
        return 0;
    case OPTION_HELP:
    case OPTION_USAGE:
        request->help = true;
        argp_state_help(state, stdout, (key == OPTION_HELP ? ARGP_HELP_STD_HELP : ARGP_HELP_USAGE) &
                                           ~(unsigned)ARGP_HELP_EXIT_OK);
        return 0;
    case ARGP_KEY_ARG:
        if (request->path_count < 2)
            request->paths[request->path_count] = text;
        request->path_count++;
        return 0;
    case ARGP_KEY_END:
        if (request->help || request->path_count == 2)
            return 0;
        fprintf(stderr, "%s: needs two PNG files, has %d; see --help\n", state->name,
                request->path_count);
        return EINVAL;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static int compare_run(int argc, char **argv)
{
    static const struct argp_option options[] = {
        {"max-channel", OPTION_MAX_CHANNEL, "LEVELS", 0,
         "Channels (0 to 255) may differ by this much (default 2)", 0},
        {"max-fraction", OPTION_MAX_FRACTION, "PART", 0,
         "This part of the pixels may differ by more (default 0.001)", 0},
        {"diff", OPTION_DIFF, "D.png", 0, "Write the differences, 16 times amplified", 0},
        {"help", OPTION_HELP, NULL, 0, "Print this help", -1},
        {"usage", OPTION_USAGE, NULL, 0, "Print the options in short", -1},
        {0}};
    static const struct argp argp = {
        options, option_read, "A.png B.png",
        "Says whether two pictures are the same."
        "\vExit code: 0 same, 1 different, 2 error.", NULL, NULL, NULL};
    static char name[] = "sph-render compare"; /* for argp's messages */
    struct request request = {.max_channel = 2, .max_fraction = 0.001};
    argv[0] = name;
    if (argp_parse(&argp, argc, argv, ARGP_NO_EXIT | ARGP_NO_HELP, NULL, &request) != 0)
        return EXIT_ERROR;
    return request.help ? 0 : compare(&request);
}

const struct tool tool_compare = {
    .variant = {.name = "compare", .doc = "says whether two pictures are the same"},
    .run = compare_run,
};
