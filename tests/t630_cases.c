/* Tests the validation cases: columns of the exact solution have no error, perturbed ones theirs. */
#include "case_fixture.h"

#include "study/reference/exact.h"
#include "study/reference/martin_moyce.h"

static void free_fall(void **state)
{
    struct fixture t;
    (void)state;
    open_case(&t, "free-fall", "free-fall");
    double *low = values(&t, "extent.y.min");
    for (size_t row = 0; row < t.columns.rows; row++)
        low[row] = 2.225 - 9.81 / 2 * pow(t.columns.values[0][row], 2);
    all_below(&t, 1e-12);
    low[t.columns.rows - 1] += 1e-3;
    compare(&t);
    near(&t, "height", 1e-3, 1e-12);
    close_case(&t);
}

/* nu = 0.1 m^2/s, and with other settings another one, width and force. */
static void channels(void **state)
{
    static const char *const set[3] = {"fluids.0.viscosity=50", "gravity=[3,0,0]",
                                       "domain.min=[0,-1,0]"};
    static const char *const names[5] = {
        "velocity, L2 at t nu/H^2 = 0.0225", "velocity, L2 at t nu/H^2 = 0.045",
        "velocity, L2 at t nu/H^2 = 0.1125", "velocity, L2 at t nu/H^2 = 0.225",
        "velocity, L2 at t nu/H^2 = 1"};
    (void)state;
    for (int kind = 0; kind < 3; kind++) {
        struct fixture t;
        int layers = kind == 2 ? 40 : 20;
        open_with(&t, kind == 1 ? "couette" : "poiseuille", kind == 1 ? "couette" : "poiseuille",
                  set, kind == 2 ? 3 : 0);
        for (int k = 0; k < layers; k++)
            for (size_t row = 0; row < t.columns.rows; row++) {
                double y = 0.05 * k + 0.03, time = t.columns.values[0][row];
                point(&t, "layers", k, "coordinate")[row] = kind == 2 ? y - 1 : y;
                point(&t, "layers", k, "velocity.x")[row] =
                    kind == 0   ? exact_poiseuille(y, time, 0.1, 1.2, 1)
                    : kind == 1 ? exact_couette(y, time, 0.1, 1.5, 1)
                                : exact_poiseuille(y, time, 0.05, 3, 2);
            }
        all_below(&t, 1e-12);
        assert_int_equal(t.errors.count, kind == 2 ? 3 : 5); /* H^2/nu is 80 s, the end 10 s */
        for (int k = 0; k < layers; k++)
            scale(point(&t, "layers", k, "velocity.x"), &t, 0.98);
        compare(&t);
        for (size_t k = 0; k < t.errors.count; k++)
            near(&t, names[k], 0.02, 1e-12);
        t.columns.rows = 9; /* before t nu/H^2 = 0.0225 */
        stops(&t);
        close_case(&t);
    }
}

static void vortices(void **state)
{
    static const char *const names[3] = {"taylor-green", "taylor-green", "beltrami"};
    static const char *const scenes[3] = {"taylor-green-jitter", "taylor-green-lattice",
                                          "beltrami"};
    (void)state;
    for (int kind = 0; kind < 3; kind++) {
        struct fixture t;
        open_case(&t, names[kind], scenes[kind]);
        double rate = (kind == 2 ? 4 : 8) * M_PI * M_PI / 100, squares = 0, change = 0;
        double *energy = values(&t, "energy.kinetic"), *speed = values(&t, "flow-error.speed");
        for (size_t row = 0; row < t.columns.rows; row++)
            energy[row] = 7 * exp(-2 * rate * t.columns.values[0][row]);
        all_below(&t, 1e-12);
        for (size_t row = 0; row < t.columns.rows; row++)
            squares += pow(energy[row] / 7, 2);
        change = 0.1 * energy[50] / 7;
        energy[50] *= 1.1; /* at 1 s */
        speed[t.columns.rows - 1] = 0.02;
        compare(&t);
        near(&t, "kinetic energy at t = 1 s", 0.1, 1e-12);
        near(&t, "kinetic energy, L2", change / sqrt(squares), 1e-12);
        near(&t, kind == 2 ? "speed, L1 at t = 1 s" : "speed, L1 at t = 2 s", 0.02, 1e-12);
        t.columns.rows = 40;
        stops(&t);
        close_case(&t);
    }
}

/* Half the pressure-free drop's axes: 0.514266 and 1.944517 m at 0.0076 s. */
static void elliptic_drop(void **state)
{
    struct fixture t;
    const double d = 0.025, axes[2] = {0.514266, 1.944517};
    static const char *const names[2][3] = {{"spread.x", "extent.x.max", "extent.x.high"},
                                            {"spread.y", "extent.y.max", "extent.y.high"}};
    static const char *const lows[2][2] = {{"extent.x.min", "extent.x.low"},
                                           {"extent.y.min", "extent.y.low"}};
    (void)state;
    open_case(&t, "elliptic-drop", "elliptic-drop");
    size_t last = t.columns.rows - 1;
    fill(values(&t, "energy.kinetic"), &t, 5);
    for (int a = 0; a < 2; a++) {
        fill(values(&t, names[a][0]), &t, sqrt(0.25 - d * d / 12));
        values(&t, names[a][0])[last] = sqrt(axes[a] * axes[a] / 4 - d * d / 12);
        values(&t, names[a][1])[last] = axes[a] - d / 2 + 0.1; /* the middle may move */
        values(&t, lows[a][0])[last] = -axes[a] + d / 2 + 0.1;
        values(&t, names[a][2])[last] = axes[a] * exact_ellipse_reach(0.005);
        values(&t, lows[a][1])[last] = -axes[a] * exact_ellipse_reach(0.005);
    }
    all_below(&t, 1e-6);
    assert_int_equal(t.errors.count, 9);
    values(&t, "energy.kinetic")[last] = 4.9;
    values(&t, "spread.y")[last] = sqrt(pow(1.01 * axes[1], 2) / 4 - d * d / 12);
    values(&t, "spread.x")[0] = sqrt(pow(0.99, 2) / 4 - d * d / 12);
    values(&t, "extent.x.high")[last] += 0.02 * axes[0] * exact_ellipse_reach(0.005);
    values(&t, "extent.y.min")[last] -= 0.02 * axes[1];
    compare(&t);
    near(&t, "short semi-axis by moments", 0, 1e-6);
    near(&t, "long semi-axis by moments", 0.01, 1e-6);
    near(&t, "short semi-axis by 99.5 % extents", 0.01, 1e-6);
    near(&t, "long semi-axis by outermost particles", 0.01, 1e-6);
    near(&t, "semi-axis along x by moments at t = 0", -0.01, 1e-6);
    near(&t, "semi-axis along y by moments at t = 0", 0, 1e-6);
    near(&t, "kinetic energy, drift", -0.02, 1e-12);
    close_case(&t);
}

/* Spreads of the exact drop with its clock `slower` and its waves smaller by `loss` in a second. */
static void fill_oscillation(struct fixture *t, double slower, double loss)
{
    double d2 = 0.05 * 0.05 / 12;
    for (size_t row = 0; row < t->columns.rows; row++) {
        double time = t->columns.values[0][row], keep = exp(-loss * time);
        struct exact_ellipse drop = exact_oscillating_drop(time / slower, 0.5, 1, 1);
        double middle = (pow(drop.axes[0], 2) + pow(drop.axes[1], 2)) / 8;
        double wave = keep * (pow(drop.axes[1], 2) - pow(drop.axes[0], 2)) / 8;
        values(t, "spread.x")[row] = sqrt(middle - wave - d2);
        values(t, "spread.y")[row] = sqrt(middle + wave - d2);
    }
}

static void oscillating_drop(void **state)
{
    struct fixture t;
    (void)state;
    open_case(&t, "oscillating-drop", "oscillating-drop");
    fill_oscillation(&t, 1, 0);
    all_below(&t, 2e-3); /* rows miss the peaks by up to 0.025 s */
    near(&t, "period", 0, 1e-4);
    near(&t, "semi-axis along x by moments at t = 0", 0, 1e-12);
    fill_oscillation(&t, 1.01, 0.02);
    compare(&t);
    near(&t, "period", 0.01, 1e-3);
    near(&t, "first amplitude", exp(-0.02 * 4.567 * 1.01 / 4) - 1, 3e-3);
    near(&t, "amplitude, change in a period", exp(-0.02 * 4.567 * 1.01) - 1, 3e-3);
    t.columns.rows = 130; /* 6.45 s, two changes of sign */
    stops(&t);
    close_case(&t);
}

/* R = 1 cm, sigma = 0.07 N/m, mu = 0.02 Pa s: omega^2 = 560, damping 1 /s, 14 Pa. */
static void capillary_drop(void **state)
{
    struct fixture t;
    (void)state;
    open_case(&t, "capillary-drop", "capillary-drop");
    for (int wrong = 0; wrong < 2; wrong++) {
        for (size_t row = 0; row < t.columns.rows; row++) {
            double time = t.columns.values[0][row], faster = wrong ? 1.02 : 1;
            double wave = exp(-time / (wrong ? 2 : 1)) * sin(sqrt(560) * faster * time);
            values(&t, "spread.x")[row] = sqrt(2e-5 - 1e-6 * wave);
            values(&t, "spread.y")[row] = sqrt(2e-5 + 1e-6 * wave);
            values(&t, "pressure")[row] = 2 * row < t.columns.rows - 1 ? 99 : wrong ? 14.7 : 14;
        }
        compare(&t);
        near(&t, "period", wrong ? 1 / 1.02 - 1 : 0, 2e-3);
        near(&t, "damping", wrong ? -0.5 : 0, 0.02);
        near(&t, "pressure", wrong ? 0.05 : 0, 1e-12);
    }
    t.columns.rows = 40;
    stops(&t);
    close_case(&t);
}

static void square_patch(void **state)
{
    struct fixture t;
    (void)state;
    open_case(&t, "square-patch", "square-patch");
    fill(values(&t, "energy.kinetic"), &t, 3);
    fill(values(&t, "angular-momentum.z"), &t, -4);
    all_below(&t, 1e-12);
    values(&t, "energy.kinetic")[t.columns.rows - 1] = 2.97;
    values(&t, "angular-momentum.z")[t.columns.rows - 1] = -4.08;
    compare(&t);
    near(&t, "kinetic energy, drift", -0.01, 1e-12);
    near(&t, "angular momentum, drift", 0.02, 1e-12);
    close_case(&t);
}

/* A = 0.05 m on 1 m, as linear viscous theory has it, while the tank settles. */
static void standing_wave(void **state)
{
    struct fixture t;
    struct exact_wave wave = exact_viscous_wave(1, 2, sqrt(9.81) / 250, 9.81);
    (void)state;
    open_case(&t, "standing-wave", "standing-wave");
    for (int wrong = 0; wrong < 2; wrong++) {
        double omega = wave.frequency * (wrong ? 1.03 : 1), rate = wave.damping * (wrong ? 1.2 : 1);
        for (size_t row = 0; row < t.columns.rows; row++) {
            double time = t.columns.values[0][row];
            values(&t, "wave.cosine")[row] = (wrong ? 0.02 : 0.025) * exp(-rate * time) *
                                             sin(omega * time) + 1e-3 - 1e-4 * time;
        }
        compare(&t);
        near(&t, "frequency, of sqrt(g k tanh kH)", omega / 5.541131024 - 1, 1e-6);
        near(&t, "damping rate, of 2 nu k^2", wrong ? 1.2 * 0.8931866 - 1 : -0.1068134, 1e-5);
        near(&t, "frequency, of linear viscous theory", wrong ? 0.03 : 0, 1e-6);
        near(&t, "damping rate, of the same", wrong ? 0.2 : 0, 1e-5);
        near(&t, "amplitude", wrong ? -0.2 : 0, 1e-5);
    }
    close_case(&t);
    static const char *const inviscid[1] = {"fluids.0.viscosity=0"};
    open_with(&t, "standing-wave", "standing-wave", inviscid, 1);
    for (size_t row = 0; row < t.columns.rows; row++)
        values(&t, "wave.cosine")[row] = 0.025 * sin(5.541131024 * t.columns.values[0][row]);
    all_below(&t, 1e-6);
    assert_int_equal(t.errors.count, 3); /* there is no damping */
    close_case(&t);
}

/* The front of Table 2 at a time, its clock 0.3 too late and slower from Z = 1.44 on; m. */
static double front_at(double time, double slower)
{
    double ts[MARTIN_MOYCE_FRONTS], zs[MARTIN_MOYCE_FRONTS];
    for (int k = 0; k < MARTIN_MOYCE_FRONTS; k++) {
        ts[k] = 1.19 + (martin_moyce_fronts[k].mean - 1.19) * slower + 0.3;
        zs[k] = martin_moyce_fronts[k].z;
    }
    double z = columns_interpolate(ts, zs, MARTIN_MOYCE_FRONTS, time * sqrt(2 * 9.81 / 0.05715));
    return 0.05715 * (isnan(z) ? 1 : z);
}

/* Of Table 6, from the whole height at first, m. */
static double height_at(double time)
{
    double taus[MARTIN_MOYCE_HEIGHTS + 1] = {0}, hs[MARTIN_MOYCE_HEIGHTS + 1] = {1};
    for (int k = 0; k < MARTIN_MOYCE_HEIGHTS; k++) {
        taus[k + 1] = martin_moyce_heights[k].tau;
        hs[k + 1] = martin_moyce_heights[k].h;
    }
    return 2 * 0.05715 * columns_interpolate(taus, hs, MARTIN_MOYCE_HEIGHTS + 1,
                                             time * sqrt(9.81 / 0.05715));
}

/* Rows lie between the tables' points, so that their corners are rounded off a little. */
static void martin_moyce(void **state)
{
    struct fixture t;
    (void)state;
    open_case(&t, "martin-moyce", "martin-moyce");
    for (int wrong = 0; wrong < 2; wrong++) {
        double squares = 0, count = 0;
        for (size_t row = 0; row < t.columns.rows; row++) {
            double time = t.columns.values[0][row], h = height_at(time);
            values(&t, "front.position")[row] = front_at(time, wrong ? 1.1 : 1);
            values(&t, "wall1")[row] = 0; /* the median is taken */
            values(&t, "wall2")[row] = h + (wrong ? 0.02 * 2 * 0.05715 : 0);
            values(&t, "wall3")[row] = 1;
        }
        double reached = 1.19 + (0.35 * sqrt(2 * 9.81 / 0.05715) - 0.3 - 1.19) / 1.1;
        for (int k = 3; k < MARTIN_MOYCE_FRONTS && martin_moyce_fronts[k].mean < reached; k++) {
            squares += pow(0.1 * (1 - 1.19 / martin_moyce_fronts[k].mean), 2);
            count++;
        }
        compare(&t);
        near(&t, "time of the front, RMS", wrong ? sqrt(squares / count) : 0, 1e-3);
        near(&t, "height at the wall, RMS, of 2 a", wrong ? 0.02 : 0, 2e-3);
        if (!wrong)
            near(&t, "front outside of the runs", 0, 0);
    }
    fill(values(&t, "front.position"), &t, 0.06);
    stops(&t);
    close_case(&t);
}

/* Of a tank of 1 m: pressures 15 cm to 85 cm up; before the last quarter there may be anything. */
static void fill_tank(struct fixture *t, double depth, double margin, int points)
{
    for (size_t row = 0; row < t->columns.rows; row++) {
        bool late = t->columns.values[0][row] > 0.74 * t->scene->time.end;
        for (int k = 0; k < points; k++) {
            double y = margin + (depth - 2 * margin) * k / (points - 1);
            point(t, "up", k, "pressure")[row] = late ? 9810 * (depth - y) : 5;
        }
        values(t, "floor")[row] = late ? 9810 * depth : -3;
        values(t, "volume.surface")[row] = late || row == 0 ? 0.25 : 7;
        values(t, "mass-centre.y")[row] = late || row == 0 ? depth / 2 : 7;
        values(t, "energy.kinetic")[row] = late ? 0 : 1e6;
    }
}

static void hydrostatic(void **state)
{
    struct fixture t;
    (void)state;
    open_case(&t, "hydrostatic", "hydrostatic-20");
    fill_tank(&t, 1, 0.15, 15);
    all_below(&t, 1e-12);
    assert_int_equal(t.errors.count, 6);
    for (int k = 0; k < 15; k++) /* 3 % up and down by turns: no error of the mean */
        for (size_t row = 0; row < t.columns.rows; row++)
            point(&t, "up", k, "pressure")[row] *= row % 2 ? 1.03 : 0.97;
    scale(values(&t, "floor"), &t, 0.98);
    scale(values(&t, "volume.surface") + 1, &(struct fixture){.columns.rows = t.columns.rows - 1},
          1.01);
    scale(values(&t, "mass-centre.y") + 1, &(struct fixture){.columns.rows = t.columns.rows - 1},
          0.99);
    fill(values(&t, "energy.kinetic"), &t, 1e-5 * 1000 * 0.25 * 9.81);
    compare(&t);
    near(&t, "pressure, L2 over points and time", 0.03, 1e-12);
    near(&t, "pressure, L2 of its mean", 0.03 / 17, 1e-12); /* 17 late rows */
    near(&t, "pressure on the floor", -0.02, 1e-12);
    near(&t, "volume below the surface, drift", 0.01, 1e-12);
    near(&t, "mass centre, drift", -0.01, 1e-12);
    near(&t, "kinetic energy / M g H", 1e-5, 1e-15);
    close_case(&t);
}

static void deep_column(void **state)
{
    struct fixture t;
    (void)state;
    open_case(&t, "deep-column", "column-100m");
    fill_tank(&t, 100, 7.5, 35);
    all_below(&t, 1e-12);
    for (int k = 0; k < 35; k++)
        scale(point(&t, "up", k, "pressure"), &t, 1.02);
    compare(&t);
    near(&t, "slope of pressure", 0.02, 1e-12);
    close_case(&t);
}

/* Gravity (4.905, -8.4957, 0) in half a metre: linear pressures, with any constant. */
static void hydrostatic_tilted(void **state)
{
    static const char *const lines[3] = {"across", "up", "along"};
    const double gx = 4.905, gy = -8.495709211, reach = 0.175 / 8.495709211;
    struct fixture t;
    (void)state;
    open_case(&t, "hydrostatic-tilted", "hydrostatic-tilted");
    double exact = 0, wave = 0;
    for (int k = 0; k < 30; k++) {
        double part = k % 10 / 4.5 - 1; /* -1 to 1 */
        double x = k < 10 ? 0.175 * part : k < 20 ? 0 : reach * gx * part;
        double y = k < 10 ? 0 : k < 20 ? 0.175 * part : reach * gy * part;
        double p = 1000 * (gx * (0.25 + x) + gy * (y - 0.25));
        double *column = point(&t, lines[k / 10], k % 10, "pressure");
        for (size_t row = 0; row < t.columns.rows; row++)
            column[row] = p + 1e5 + (row < 30 ? 1e7 : 0);
        exact += p * p;
        wave += 50 * 50;
    }
    fill(values(&t, "mass-centre.x"), &t, 0.25);
    all_below(&t, 1e-8);
    for (int k = 0; k < 30; k++) /* 50 Pa up and down along the lines */
        for (size_t row = 0; row < t.columns.rows; row++)
            point(&t, lines[k / 10], k % 10, "pressure")[row] += k % 2 ? 50 : -50;
    for (size_t row = 1; row < t.columns.rows; row++) {
        values(&t, "mass-centre.x")[row] += 0.003;
        values(&t, "mass-centre.y")[row] -= 0.004;
        values(&t, "energy.kinetic")[row] = 2;
    }
    compare(&t);
    double drop = 0.5 * (4.905 + 8.495709211) / 9.81;
    near(&t, "pressure but for a constant, L2 over points and time", sqrt(wave / exact), 1e-9);
    near(&t, "mass centre moved, of H", 0.005 / drop, 1e-9);
    near(&t, "kinetic energy / M g H", 2 / (125 * 9.81 * drop), 1e-9);
    close_case(&t);
}

/* Each row of the table says what it is, and refuses scenes that are not for it. */
static void cases_check_scenes(void **state)
{
    static const char *const empty[1] = {"bodies=[]"};
    struct scene *none = scene_of("free-fall", empty, 1), *other = scene_of("free-fall", NULL, 0);
    (void)state;
    assert_int_equal(case_table.count, 14);
    for (size_t k = 0; k < case_table.count; k++) {
        const struct case_row *row = (const void *)case_table.rows[k];
        struct error e;
        assert_true(strlen(row->variant.doc) > 20 && row->interval && row->measure);
        assert_int_equal(case_check(row, none, &e), STATUS_USAGE);
        assert_non_null(strstr(e.text, row->variant.name));
        bool suits = strcmp(row->variant.name, "free-fall") == 0 || strstr(row->variant.doc, "tank") ||
                     strstr(row->variant.doc, "full box");
        assert_int_equal(case_check(row, other, &e), suits ? STATUS_OK : STATUS_USAGE);
    }
    scene_free(none);
    scene_free(other);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(free_fall), cmocka_unit_test(channels), cmocka_unit_test(vortices),
        cmocka_unit_test(elliptic_drop), cmocka_unit_test(oscillating_drop),
        cmocka_unit_test(capillary_drop), cmocka_unit_test(square_patch),
        cmocka_unit_test(standing_wave), cmocka_unit_test(martin_moyce),
        cmocka_unit_test(hydrostatic), cmocka_unit_test(deep_column),
        cmocka_unit_test(hydrostatic_tilted), cmocka_unit_test(cases_check_scenes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
