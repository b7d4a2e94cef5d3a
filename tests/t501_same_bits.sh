#!/bin/sh
# Tests that states have the same bits for any number of threads, instruction set, compiler and
# neighbour search: state hashes of every frame, hundreds of steps beyond the first impact.
. tests/bits.sh
worth='.steps >= 400'
least=10
compare "dam break" scenes/dambreak.json --set 'solver={"method": "dfsph"}' \
    --set particles.spacing=0.05 --end 1.6 --fps 15
compare "explicit dam break" tests/scenes/dam.json
compare "two fluids" tests/scenes/two-fluids.json
compare "two fluids, pressure midway" tests/scenes/two-fluids.json --set solver.pressure_form=average
compare "wall particles" tests/scenes/wall-particles.json
compare "diffusion by gradients" tests/scenes/dam.json --set solver.diffusion_form=antuono
compare "two fluids, diffusion by gradients" tests/scenes/two-fluids.json \
    --set solver.pressure_form=average --set solver.diffusion_form=antuono
compare "wall particles, diffusion by gradients" tests/scenes/wall-particles.json \
    --set solver.diffusion_form=antuono --set solver.kernel=cubic-spline
compare "muller" scenes/muller-splash.json --set particles.spacing=0.07 --end 0.8 --fps 30
compare "periodic" tests/scenes/periodic.json
compare "particle shifting" tests/scenes/taylor-green.json
compare "shifting between wall particles" tests/scenes/wall-particles.json --set solver.shifting=on
compare "obstacles" tests/scenes/obstacles.json --set 'solver={"method": "wcsph"}' --set particles.spacing=0.035 --end 0.35 --fps 40
echo "1..$n"
