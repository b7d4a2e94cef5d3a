#!/bin/sh
# Tests that implicit viscosity of either operator gives the same bits for any number of threads,
# instruction set, neighbour search and compiler.
. tests/bits.sh
worth='.solves.viscosity.sweeps > 100 and .solves.viscosity.unsolved == 0'
least=10
compare "along the line of centres" tests/scenes/honey.json
compare "Laplacian" tests/scenes/honey.json --set 'solver.viscosity_form="morris"'
compare "isph" tests/scenes/honey.json --set 'solver.method="isph"'
echo "1..$n"
