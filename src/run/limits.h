/* What limits the time step at the present state, each limit by name. */
#ifndef RUN_LIMITS_H
#define RUN_LIMITS_H

struct simulation;

enum limit {
    LIMIT_ACOUSTIC, /* sound and flow cross a part of h */
    LIMIT_SPEED,    /* the flow crosses a part of the spacing */
    LIMIT_FORCE,    /* so does a particle that starts from rest */
    LIMIT_VISCOUS,  /* momentum diffuses over a part of h */
    LIMIT_CAPILLARY,/* capillary waves of length h cross a part of it */
    LIMIT_DAMPING,  /* dissipation takes a part of the velocity */
    LIMIT_GROWTH,   /* a step is at most a tenth longer than the last */
    LIMIT_USER,     /* time.step */
    LIMIT_COUNT
};

/* "viscous limit (h^2 rho/mu)"; and the one word of reports, "viscous" */
extern const char *const limit_names[LIMIT_COUNT];
extern const char *const limit_words[LIMIT_COUNT];

/* How each is computed, for a person; NULL: no law of physics. C: time.cfl or the method's. */
extern const char *const limit_formulas[LIMIT_COUNT];

/* All limits, s; INFINITY where one does not apply. */
void limits_now(const struct simulation *s, double limit[LIMIT_COUNT]);

/* The least of those in the mask; *which, unless NULL, says which. */
double limits_least(const double limit[LIMIT_COUNT], unsigned mask, enum limit *which);

#define LIMITS_ALL ((1u << LIMIT_COUNT) - 1)
#define LIMITS_PHYSICAL (LIMITS_ALL & ~(1u << LIMIT_USER | 1u << LIMIT_GROWTH))

#endif
