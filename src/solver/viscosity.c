/* Chooses how an implicit solver treats viscosity. */
#include "scene/key.h"
#include "solver/solver.h"

#include <math.h>
#include <string.h>

enum { DRAG_ITERATIONS_MAX = 200 };

/* One operator for all pairs, of both explicit and implicit steps (pair_viscosity). Morris's brakes a
 * rotation at a surface, without which it is the more accurate. */
static void choose_form(const struct scene *scene, struct solver_choice *choice)
{
    const char *asked = scene_text(scene, "solver.viscosity_form");
    choice->form_asked = strcmp(asked, "auto") != 0;
    bool morris = choice->form_asked ? strcmp(asked, "morris") == 0 : choice->enclosed;
    /* Stiffer by 5/3 for compression, which pressure undoes; and isph starts channel flow more exactly. */
    if (!morris || choice->projects)
        choice->limits.viscous *= 0.6;
    if (morris)
        return;
    choice->flags |= PAIR_CENTRAL;
    choice->pair.central =
        (float)kernel_lattice_central(choice->kernel, choice->support / choice->spacing);
    kernel_plane_drag(choice->kernel, true, &choice->each.planes);
}

/* Viscosity is solved for where explicit steps would be VISCOSITY_STEPS times shorter than those in which
 * the fastest expected flow moves a particle by cfl 0.4 d and gravity lets it fall d / 200. Up to that,
 * explicit steps cost no more than twice as much and are of second order: the start of channel flow at
 * H/d = 20 was wrong by 0.7 % instead of 1.9 %. */
void viscosity_choose(const struct scene *scene, struct solver_choice *choice)
{
    const char *asked = scene_text(scene, "solver.viscosity");
    const double *g = scene->gravity;
    double gravity = sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
    double flow = choice->cfl * 0.4 * choice->spacing / choice->fastest;
    double fall = 0.1 * sqrt(choice->spacing / gravity);
    choice->other_step = fmin(choice->limits.user, fmin(flow, fall));
    if (!(choice->flags & (PAIR_VISCOUS | PAIR_OWN_VISCOSITY)))
        return;
    choose_form(scene, choice);
    choice->flags |= PAIR_DRAG_ONLY;
    choice->viscous_step = choice->limits.viscous;
    choice->implicit_viscosity = strcmp(asked, "implicit") == 0 ||
        (strcmp(asked, "auto") == 0 && VISCOSITY_STEPS * choice->viscous_step < choice->other_step);
    if (choice->implicit_viscosity)
        choice->limits.viscous = INFINITY;
    choice->solves[SOLVE_VISCOSITY] = (struct solve_limits){
        .tolerance = scene_real(scene, "solver.viscosity_error"), .least = 1,
        .most = DRAG_ITERATIONS_MAX};
}
