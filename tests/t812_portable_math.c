/* Portable sine, cosine, tangent and logarithm against long double ones of libm. */
#include "base/portable_math.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <math.h>
#include <stdio.h>

enum { COUNT = 300000 };

/* Uniform in 0..1 by index. */
static double part(uint64_t i)
{
    uint64_t x = (i + 1) * 0x9e3779b97f4a7c15u;
    x = (x ^ x >> 31) * 0xd1342543de82ef95u;
    return (double)((x ^ x >> 29) >> 11) * 0x1p-53;
}

/* Distance in units of the last place of the right one. */
static double off(double is, long double right)
{
    int e;
    frexp((double)right, &e);
    return (double)fabsl((long double)is - right) / ldexp(1, e - 53);
}

static void worst_is(const char *what, double worst, double bound)
{
    printf("# %s: %.3f ulp\n", what, worst);
    assert_true(worst <= bound);
}

static void circle(void **state)
{
    double worst[3] = {0, 0, 0};
    (void)state;
    for (uint64_t i = 0; i < COUNT; i++) {
        double x = (part(i) - 0.5) * (i % 3 ? 13 : 2000);
        worst[0] = fmax(worst[0], off(portable_sin(x), sinl(x)));
        worst[1] = fmax(worst[1], off(portable_cos(x), cosl(x)));
        worst[2] = fmax(worst[2], off(portable_tan(x), tanl(x)));
    }
    worst_is("sin", worst[0], 2);
    worst_is("cos", worst[1], 2);
    worst_is("tan", worst[2], 4);
    assert_true(portable_sin(0) == 0 && portable_cos(0) == 1 && portable_tan(0) == 0);
    assert_true(isnan(portable_sin((double)NAN)) && isnan(portable_cos((double)INFINITY)));
    assert_true(isnan(portable_tan(1001)));
}

static void logarithm(void **state)
{
    double worst = 0;
    (void)state;
    for (uint64_t i = 0; i < COUNT; i++) {
        double p = part(i), x = i % 3 == 0 ? p + 0.5 : i % 3 == 1 ? 1000 * p : ldexp(p + 0.5, (int)(i % 2000) - 1000);
        if (x > 0)
            worst = fmax(worst, off(portable_log(x), logl(x)));
    }
    worst_is("log", worst, 2);
    assert_true(portable_log(1) == 0);
    assert_true(isnan(portable_log(0)) && isnan(portable_log(-1)) && isnan(portable_log((double)NAN)));
    assert_true(isinf(portable_log((double)INFINITY)));
    assert_true(off(portable_log(0x1p-1074), logl(0x1p-1074L)) <= 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(circle), cmocka_unit_test(logarithm)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
