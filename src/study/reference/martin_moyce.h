/* Measured collapse of a column of water: J. C. Martin and W. J. Moyce, "An experimental study of the
 * collapse of liquid columns on a rigid horizontal plane", Phil. Trans. R. Soc. A 244 (1952) 312-324,
 * doi:10.1098/rsta.1952.0006. The column has width a = 2.25 in and height 2 a. */
#ifndef STUDY_MARTIN_MOYCE_H
#define STUDY_MARTIN_MOYCE_H

#include <stdbool.h>
#include <stddef.h>

/* Table 2: front Z = z/a and its time T = t sqrt(2 g/a), mean, least and greatest of the runs. Every
 * run's clock was shifted so that T = 1.19 at Z = 1.44. */
struct martin_moyce_front {
    double z, mean, least, most;
};
enum { MARTIN_MOYCE_FRONTS = 25 };
extern const struct martin_moyce_front martin_moyce_fronts[MARTIN_MOYCE_FRONTS];

/* Table 6: height H = h/(2 a) left at the back wall at tau = t sqrt(g/a). */
struct martin_moyce_height {
    double tau, h;
};
enum { MARTIN_MOYCE_HEIGHTS = 17 };
extern const struct martin_moyce_height martin_moyce_heights[MARTIN_MOYCE_HEIGHTS];

/* Scales of a column: width a, m, and g, m/s^2. */
struct martin_moyce_column {
    double width, g;
};

/* How a series compares with a table. */
struct martin_moyce_errors {
    double rms;      /* of T, relative; of H */
    double outside;  /* part of the fronts with T not within the runs */
    size_t count;    /* of rows of the table that the series reaches */
};

/* Times, s, and fronts, m from the back wall, clocks aligned at Z = 1.44, by the rows beyond it. False
 * when the front passes none. */
bool martin_moyce_compare_fronts(const struct martin_moyce_column *column, const double *times,
                                 const double *fronts, size_t count,
                                 struct martin_moyce_errors *errors);

/* Times, s, and heights at the back wall, m. False when no time is in the table's range. */
bool martin_moyce_compare_heights(const struct martin_moyce_column *column, const double *times,
                                  const double *heights, size_t count,
                                  struct martin_moyce_errors *errors);

#endif
