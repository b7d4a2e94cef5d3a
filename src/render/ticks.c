/* Where a colour bar has ticks, and what they say. */
#include "render/ticks.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NAME_BYTES = 24 }; /* of a fluid; longer ones are cut */

static void add(struct ticks *ticks, double part, const char *text)
{
    if (ticks->count == TICKS_MAX)
        return;
    ticks->items[ticks->count].part = part;
    snprintf(ticks->items[ticks->count++].text, TICK_TEXT + 4, "%s%s", *text == '-' ? "\u2212" : "",
             *text == '-' ? text + 1 : text);
}

double ticks_round(double most)
{
    double power = pow(10, floor(log10(most)));
    static const double factors[] = {5, 2};
    for (size_t i = 0; i < 2; i++)
        if (power * factors[i] <= most * (1 + 1e-9))
            return power * factors[i];
    return power;
}

/* The round step (1, 2 or 5 times a power of ten) that gives the most ticks up to `most`. */
static double tick_step(double span, int most)
{
    double power = pow(10, floor(log10(span / most)));
    static const double factors[] = {1, 2, 5, 10};
    for (size_t i = 0; i < 4; i++)
        if (span / (power * factors[i]) <= most)
            return power * factors[i];
    return power * 20;
}

/* The power of ten, a multiple of 3, that is put before the unit to keep tick texts short. */
static int tick_exponent(const double range[2])
{
    double largest = fmax(fabs(range[0]), fabs(range[1]));
    if (largest == 0 || (largest >= 0.01 && largest < 10000))
        return 0;
    return 3 * (int)floor(log10(largest) / 3 + 1e-9);
}

static void linear_make(struct ticks *ticks, const struct color_scale *scale, int most)
{
    double low = scale->range[0], high = scale->range[1], span = high - low;
    double step = tick_step(span, most), first = ceil(low / step - 1e-9);
    double unit = pow(10, ticks->exponent);
    int decimals = (int)fmin(9, fmax(0, -floor(log10(step / unit) + 1e-9)));
    for (int i = 0; i <= most && (first + i) * step <= high + 1e-9 * span; i++) {
        double value = (first + i) * step;
        char text[TICK_TEXT];
        snprintf(text, sizeof text, "%.*f", decimals, fabs(value) < step / 2 ? 0 : value / unit);
        add(ticks, scale_part(scale, value), text);
    }
}

static void power_text(char *text, size_t size, int exponent)
{
    static const char *const digits[] = {"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                         "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
    int n = abs(exponent);
    snprintf(text, size, "10%s%s%s%s", exponent < 0 ? "\u207b" : "",
             n >= 100 ? digits[n / 100 % 10] : "", n >= 10 ? digits[n / 10 % 10] : "",
             digits[n % 10]);
}

/* "10^6" and "2 10^6" with a dot, the exponent raised. */
static void times_power_text(char text[TICK_TEXT], int digit, int exponent)
{
    char power[24];
    power_text(power, sizeof power, exponent);
    if (digit > 1)
        snprintf(text, TICK_TEXT, "%d\u00b7%s", digit, power);
    else
        snprintf(text, TICK_TEXT, "%s", power);
}

/* Ticks at 1, 2 .. 9 times powers of ten; texts at every `every`th power, or (every 0) at 1, 2 and 5
 * times each. */
static void decades_make(struct ticks *ticks, const struct color_scale *scale, int every)
{
    int first = (int)floor(log10(scale->range[0]) + 1e-9);
    int last = (int)floor(log10(scale->range[1]) + 1e-9);
    bool plain = first >= -4 && last <= 4;
    for (int n = first; n <= last; n++)
        for (int digit = 1; digit < 10; digit++) {
            double value = digit * pow(10, n), part = scale_part(scale, value);
            bool said = every ? digit == 1 && n % every == 0 : digit == 1 || digit == 2 || digit == 5;
            char text[TICK_TEXT] = "";
            if (part < -1e-9 || part > 1 + 1e-9 || (!said && every > 1))
                continue;
            if (said && plain)
                snprintf(text, sizeof text, "%.5g", value);
            else if (said)
                times_power_text(text, digit, n);
            add(ticks, part, text);
        }
}

/* Less than two powers of ten, however long, have ticks like a linear bar. */
static void log_make(struct ticks *ticks, const struct color_scale *scale, int most)
{
    double decades = log10(scale->range[1] / scale->range[0]);
    if (decades < 0.7)
        linear_make(ticks, scale, most);
    else if (decades * 3 <= most && decades < 2)
        decades_make(ticks, scale, 0);
    else
        decades_make(ticks, scale, (int)fmax(1, ceil(decades / most)));
}

/* Where one colour ends and the next begins. */
static void steps_make(struct ticks *ticks, const struct color_scale *scale, int most)
{
    int every = (scale->steps + most - 1) / most;
    double unit = pow(10, ticks->exponent);
    for (int k = 0; k <= scale->steps; k++) {
        double part = (double)k / scale->steps, value = scale_value(scale, part) / unit;
        char text[TICK_TEXT] = "";
        if (k % every == 0)
            snprintf(text, sizeof text, "%.3g", fabs(value) < 1e-12 * fabs(scale->range[1]) ? 0 : value);
        add(ticks, part, text);
    }
}

/* Cut between characters. */
static void name_text(const char *name, char text[TICK_TEXT])
{
    size_t n = strlen(name);
    bool cut = n > NAME_BYTES;
    if (cut)
        for (n = NAME_BYTES - 1; n > 0 && ((unsigned char)name[n] & 0xc0) == 0x80; n--)
            ;
    snprintf(text, TICK_TEXT, "%.*s%s", (int)n, name, cut ? "\u2026" : "");
}

static void counts_make(struct ticks *ticks, const struct render_setup *setup,
                        const struct color_scale *scale, int most)
{
    int every = (scale->steps + most - 1) / most;
    for (int k = 0; k < scale->steps; k += every) {
        char text[TICK_TEXT];
        if (setup->name)
            name_text(setup->name(setup->scene, (size_t)k), text);
        else
            snprintf(text, sizeof text, "%d", k);
        add(ticks, (k + 0.5) / scale->steps, text);
    }
}

void ticks_make(struct ticks *ticks, const struct render_setup *setup,
                const struct color_scale *scale, int most)
{
    const double *range = scale->range;
    ticks->count = ticks->exponent = 0;
    if (!(range[1] > range[0]) || !isfinite(range[1] - range[0]) || (scale->log && !(range[0] > 0)))
        return;
    most = most < 2 ? 2 : most;
    ticks->exponent = scale->counts || (scale->log && scale->steps < 2) ? 0 : tick_exponent(range);
    if (scale->counts)
        counts_make(ticks, setup, scale, most);
    else if (scale->steps > 1)
        steps_make(ticks, scale, most);
    else if (scale->log)
        log_make(ticks, scale, most);
    else
        linear_make(ticks, scale, most);
}

void ticks_name(const struct ticks *ticks, const struct render_setup *setup, char *text,
                size_t size)
{
    const char *label = setup->label ? setup->label : "", *unit = setup->unit ? setup->unit : "";
    char power[40] = "";
    if (ticks->exponent)
        power_text(power, sizeof power, ticks->exponent);
    if (*unit || ticks->exponent)
        snprintf(text, size, "%s (%s%s%s)", label, power, *unit && *power ? " " : "", unit);
    else
        snprintf(text, size, "%s", label);
}
