/* Functions of libm that are the same bits with any: from + - * / alone, which IEEE 754 pins. */
#ifndef BASE_PORTABLE_MATH_H
#define BASE_PORTABLE_MATH_H

/* Radians; |angle| at most 1000, else NAN. At most 2 ulp off, the tangent 4 (t812). */
double portable_sin(double angle);
double portable_cos(double angle);
double portable_tan(double angle);

/* Natural logarithm, at most 2 ulp off; NAN unless x > 0. */
double portable_log(double x);

#endif
