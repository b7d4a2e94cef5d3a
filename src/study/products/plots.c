/* Product "plots": figures of error, time and pairs, drawn by gnuplot. */
#include "base/log.h"
#include "study/gnuplot.h"
#include "study/products/plot_script.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

/* A figure that cannot be drawn is said; its numbers and script are there. */
static enum status draw(const struct study_results *results, const struct figure *figure,
                        struct error *e)
{
    char directory[4096], script[200], log[4096];
    struct process_end end;
    snprintf(directory, sizeof directory, "%s/plots", results->directory);
    snprintf(script, sizeof script, "%s.gp", figure->stem);
    plot_path(results, figure, "log", log, sizeof log);
    if (gnuplot_run(script, directory, log, &end, e))
        return e->status;
    if (end.code)
        log_error("%s/%s: gnuplot could not draw this, and says why in %s", directory, script, log);
    else
        remove(log);
    return STATUS_OK;
}

static enum status write_figure(const struct study_results *results, const struct figure *figure,
                                bool can_draw, struct error *e)
{
    struct figure_view view;
    enum status status = figure_view(results, figure, &view, e);
    if (!status && view.count) {
        status = plot_data(results, figure, &view, e);
        if (!status)
            status = plot_script(results, figure, &view, e);
        if (!status && can_draw)
            status = draw(results, figure, e);
    }
    figure_view_free(&view);
    return status;
}

static enum status write_plots(const struct study_results *results, struct error *e)
{
    struct figure figures[FIGURES_MOST];
    char directory[4096];
    size_t count = study_figures(results, figures);
    bool can_draw = gnuplot_found();
    snprintf(directory, sizeof directory, "%s/plots", results->directory);
    if (mkdir(directory, 0777) && errno != EEXIST)
        return error_set(e, STATUS_OUTPUT, "%s: %s", directory, strerror(errno));
    if (!can_draw)
        log_info("no figures: gnuplot is missing (Debian: gnuplot-nox); their numbers and scripts are in "
                 "%s, and the same command draws them later", directory);
    for (size_t k = 0; k < count; k++)
        if (write_figure(results, &figures[k], can_draw, e))
            return e->status;
    return STATUS_OK;
}

const struct product_row product_plots = {
    {"plots", "figures of error against time and pairs: PNG, SVG, numbers and gnuplot scripts", NULL, 0,
     NULL}, write_plots};
