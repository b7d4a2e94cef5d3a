#!/bin/sh
# Tests that isph gives the same bits for any number of threads, instruction set, neighbour search and
# compiler: state hashes of every frame, a hundred or more steps of moving fluid.
. tests/bits.sh
worth='.steps >= 100 and .solves.velocity.sweeps > .steps and .solves.velocity.unsolved == 0 and
       .solves.shift.sweeps > 0 and .solves.shift.unsolved == 0'
least=20
compare "dam break" scenes/dambreak.json --set particles.spacing=0.055 --set 'solver.method="isph"' \
    --end 1.2 --fps 20
compare "vortices, enclosed" tests/scenes/projection-vortices.json
compare "two fluids" tests/scenes/projection-two-fluids.json
compare "wall particles" tests/scenes/projection-wall-particles.json
compare "obstacles" tests/scenes/obstacles.json --set particles.spacing=0.035 --end 0.8 --fps 40
compare "drop in another fluid" tests/scenes/drop-in-fluid.json --end 0.03 --fps 1000
compare "cubic spline" tests/scenes/projection-two-fluids.json --set 'solver.kernel="cubic-spline"' --end 0.8
echo "1..$n"
