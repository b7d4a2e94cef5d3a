/* Writes a ledger: the Markdown table, csv and json. */
#include "study/products/fields.h"
#include "study/ledger/ledger.h"
#include "study/ledger/looks.h"

#include "base/output.h"
#include "base/quote.h"
#include "run/report.h"

#include <math.h>
#include <string.h>

static const char *const answers[] = {
    [ANSWER_NONE] = "", [ANSWER_SAME] = "same", [ANSWER_DIFFERENT] = "different"};

static double cost(const struct ledger_row *row)
{
    return row->with - row->without;
}

/* Times of steps have the machine's noise; those of frames are measured by themselves. */
static void print_cost(const struct ledger *ledger, const struct ledger_row *row, FILE *out)
{
    if (row->feature->output)
        fprintf(out, "%.3g a frame", cost(row));
    else if (fabs(cost(row)) < ledger->noise)
        fprintf(out, "below %.2g", ledger->noise);
    else
        fprintf(out, "%+.3g ± %.2g (%+.0f %%)", cost(row), ledger->noise,
                100 * cost(row) / row->without);
}

static void print_bytes(const struct ledger_row *row, FILE *out)
{
    if (isnan(row->planned))
        fprintf(out, " | %+.0f", row->bytes);
    else
        fprintf(out, "%+.0f | %+.0f", row->planned, row->bytes);
}

/* What of the proof there is: the neutral value, the plan, and the vanishing strength. */
static void print_proof(const struct ledger_row *row, FILE *out)
{
    const struct feature_row *feature = row->feature;
    if (feature_is_look(feature)) {
        fprintf(out, "pictures with it said to be off: %s; state with it: %s", answers[row->states[STRENGTH_OFF]],
                answers[row->states[STRENGTH_ON]]);
        return;
    }
    if (feature->output)
        fprintf(out, "state with it %s", answers[row->states[STRENGTH_ON]]);
    else
        fprintf(out, "said to be off: %s", answers[row->states[STRENGTH_OFF]]);
    fprintf(out, "; plan: %s%s", row->said[0] ? "left out" : "says nothing",
            row->absent ? "" : ", BUT ITS PASS IS THERE");
    if (row->states[STRENGTH_FAINT] == ANSWER_SAME)
        fputs("; at vanishing strength: same", out);
    else if (row->states[STRENGTH_FAINT] == ANSWER_DIFFERENT)
        fputs("; at vanishing strength: different, as what is added is rounded in another order", out);
    else if (feature->why)
        fprintf(out, "; no vanishing strength: %s", feature->why);
}

static const char *effect(const struct ledger_row *row)
{
    return feature_is_look(row->feature) ? row->changes_pictures ? "changes pictures" : "NO EFFECT in this scene"
           : row->feature->output                          ? "none"
           : row->states[STRENGTH_ON] == ANSWER_DIFFERENT ? "changes the state"
                                                          : "NO EFFECT in this scene";
}

static void print_row(const struct ledger *ledger, const struct ledger_row *row, FILE *out)
{
    fprintf(out, "| %s | ", row->feature->variant.name);
    print_cost(ledger, row, out);
    fputs(" | ", out);
    if (!isnan(row->steps))
        fprintf(out, "%.3g", row->steps);
    fputs(" | ", out);
    print_bytes(row, out);
    fprintf(out, " | %s | ", effect(row));
    print_proof(row, out);
    fprintf(out, " | %s |\n", ledger_proved(row) ? "yes" : "NO");
}

static void print_list(const struct ledger *ledger, bool used, FILE *out)
{
    bool any = false;
    for (size_t k = 0; k < ledger->count; k++) {
        const struct ledger_row *row = &ledger->rows[k];
        if (used && row->used) {
            fprintf(out, "%s%s", any ? ", " : "\nUsed by the scene: ", row->feature->variant.name);
            any = true;
        } else if (!used && row->reason[0]) {
            fprintf(out, "%s- %s: %s\n", any ? "" : "\nCannot be switched on here:\n\n",
                    row->feature->variant.name, row->reason);
            any = true;
        }
    }
    fputs(used && any ? ".\n" : "", out);
}

void ledger_print(const struct ledger *ledger, const struct study_about *about, FILE *out)
{
    const struct ledger_options *o = ledger->options;
    fprintf(out, "# Left out of %s\n\n%s, %.0f particles, %s: %.3g ns of processor time per particle and step, %zu bytes a "
                 "particle by the plan, %.0f with neighbours. %s, %s, %ld steps, least of %d runs in turns.\n\n"
                 "    %s\n\n",
            ledger->title, o->scene, ledger->particles, ledger->method, ledger->ns, ledger->planned,
            ledger->bytes, report_processor(), about->date, o->steps, o->repeats, about->command);
    fputs("| left out | cost, ns per particle and step | steps, times as many | bytes a particle, plan | "
          "all memory | switched on | proof: state hash | proved |\n|---|---|---|---|---|---|---|---|\n", out);
    for (size_t k = 0; k < ledger->count; k++)
        if (!ledger->rows[k].used && !ledger->rows[k].reason[0])
            print_row(ledger, &ledger->rows[k], out);
    print_list(ledger, true, out);
    print_list(ledger, false, out);
    fprintf(out, "\nNoise of the machine: %.2g ns (%.1f %%), the largest difference between the scene and the "
                 "same scene with a feature said to be off. Iterations of solves are part of a cost, more "
                 "steps for the same time are not.\n",
            ledger->noise, 100 * ledger->noise / ledger->ns);
}

static const char *kind(const struct ledger_row *row)
{
    return row->used        ? "used"
           : row->reason[0] ? "cannot be switched on"
                            : "left out";
}

static void write_csv(const struct ledger *ledger, FILE *out)
{
    fputs("feature,kind,per,without (ns),with (ns),said to be off (ns),noise (ns),steps times,"
          "bytes by the plan,bytes,off state,on state,faint state,passes absent,proved,plan says,reason\n", out);
    for (size_t k = 0; k < ledger->count; k++) {
        const struct ledger_row *row = &ledger->rows[k];
        const double numbers[] = {row->without, row->with, row->neutral,
                                  row->feature->output ? (double)NAN : ledger->noise, row->steps,
                                  row->planned, row->bytes};
        csv_text(row->feature->variant.name, out);
        fprintf(out, ",%s,%s,", kind(row), row->feature->output ? "frame" : "step");
        for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
            csv_number(numbers[i], out);
            fputc(',', out);
        }
        fprintf(out, "%s,%s,%s,%s,%s,", answers[row->states[STRENGTH_OFF]],
                answers[row->states[STRENGTH_ON]], answers[row->states[STRENGTH_FAINT]],
                row->absent ? "yes" : "no", ledger_proved(row) ? "yes" : "no");
        csv_text(row->said, out);
        fputc(',', out);
        csv_text(row->reason, out);
        fputc('\n', out);
    }
}

static void write_json(const struct ledger *ledger, const struct study_about *about, FILE *out)
{
    fputs("{", out);
    json_text("title", ledger->title, out);
    json_text("scene", ledger->options->scene, out);
    json_text("method", ledger->method, out);
    json_text("program", "sph-render " SPH_VERSION, out);
    json_text("processor", report_processor(), out);
    json_text("command", about->command, out);
    json_text("date", about->date, out);
    json_number("particles", ledger->particles, out);
    json_number("steps", (double)ledger->options->steps, out);
    json_number("repeats", ledger->options->repeats, out);
    json_number("ns_per_particle_step", ledger->ns, out);
    json_number("noise", ledger->noise, out);
    json_number("bytes_by_plan", (double)ledger->planned, out);
    json_number("bytes", ledger->bytes, out);
    fprintf(out, "\"state\": \"%016llx\", \"features\": [", (unsigned long long)ledger->hash);
    for (size_t k = 0; k < ledger->count; k++) {
        const struct ledger_row *row = &ledger->rows[k];
        fputs(k ? ",\n  {" : "\n  {", out);
        json_text("name", row->feature->variant.name, out);
        json_text("kind", kind(row), out);
        json_text("reason", row->reason, out);
        json_text("plan_says", row->said, out);
        json_number("without", row->without, out);
        json_number("with", row->with, out);
        json_number("said_to_be_off", row->neutral, out);
        json_number("steps_times", row->steps, out);
        json_number("bytes_by_plan", row->planned, out);
        json_number("bytes", row->bytes, out);
        fprintf(out, "\"changes_pictures\": %s, ", row->changes_pictures ? "true" : "false");
        json_text("off_state", answers[row->states[STRENGTH_OFF]], out);
        json_text("on_state", answers[row->states[STRENGTH_ON]], out);
        json_text("faint_state", answers[row->states[STRENGTH_FAINT]], out);
        fprintf(out, "\"passes_absent\": %s, \"proved\": %s}", row->absent ? "true" : "false",
                ledger_proved(row) ? "true" : "false");
    }
    fputs("]}\n", out);
}

enum status ledger_write(const struct ledger *ledger, const struct study_about *about, struct error *e)
{
    static const char *const names[] = {"ledger.csv", "ledger.json", "ledger.md"};
    for (int k = 0; k < 3; k++) {
        char path[4096];
        struct output_file file;
        snprintf(path, sizeof path, "%s/%s", ledger->options->directory, names[k]);
        if (output_open(&file, path, e))
            return e->status;
        if (k == 0)
            write_csv(ledger, file.stream);
        else
            (k == 1 ? write_json : ledger_print)(ledger, about, file.stream);
        if (output_close(&file, true, e))
            return e->status;
    }
    return STATUS_OK;
}
