#!/bin/sh
# Tests particle shifting: decay of Taylor-Green vortices, momentum, walls hold, when it is on.
. tests/tap.sh
export OMP_WAIT_POLICY=passive
vortices=tests/scenes/taylor-green.json

# decay NAME LEAST MOST ARGUMENTS...: error of kinetic energy at 0.5 s, exact exp(-16 pi^2 t/100)
decay() {
    name=$1 least=$2 most=$3
    shift 3
    "$SPH" -q $vortices "$@" -o "$work/flow.csv" >"$work/out" 2>&1
    error=$(awk -F, '!/^#/ && $1 == 0 { k = $2 } !/^#/ { last = $2 }
                     END { print last / k / exp(-0.5 * 16 * 3.14159265^2 / 100) - 1 }' "$work/flow.csv")
    awk "BEGIN { exit !($error > $least && $error < $most) }"
    result $? "$name: error of kinetic energy $error"
}
decay "from a lattice" -0.05 0.05
decay "from a jittered lattice" -0.08 0.05 --set bodies.0.jitter=0.2
# Columns 5 to 7: momentum, kg m/s; 280 kg at a mean 0.6 m/s pass 170.
most=$(awk -F, '!/^#/ && NR > 1 { for (k = 5; k <= 7; k++) { a = $k < 0 ? -$k : $k; if (a > m) m = a } }
               END { print m + 0 }' "$work/flow.csv")
awk "BEGIN { exit !($most < 0.8) }"
result $? "momentum stays near zero: $most kg m/s"
decay "without shifting" -1 -0.2 --set solver.shifting=off

"$SPH" -q tests/scenes/dam.json --set solver.shifting=on --set 'measure=[{"quantity": "extent"}]' \
    -o "$work/dam.csv" >"$work/out" 2>&1
awk -F, 'NR == 1 { for (k = 1; k <= NF; k++) name[k] = $k; next }
         { for (k = 2; k <= NF; k++)
               if ($k < 0 || (name[k] ~ /x\./ && $k > 1.6) || (name[k] ~ /z\./ && $k > 0.67)) bad = 1 }
         END { exit bad || NR < 5 }' "$work/dam.csv"
result $? "walls hold shifting particles"

"$SPH" $vortices --plan >"$work/out" 2>&1
grep -q "shift .*pair" "$work/out"
result $? "it is on where fluid fills a periodic domain"
"$SPH" tests/scenes/dam.json --plan >"$work/out" 2>&1
grep -q "^  pass shift: not one fluid" "$work/out" && ! grep -q "shift .*pair" "$work/out"
result $? "and left out where there is a surface"
"$SPH" $vortices --set solver.shifting=on --set solver.pressure_form=symmetric --check >"$work/out" 2>&1
[ $? = 2 ] && grep -q "solver.shifting needs" "$work/out"
result $? "refused with symmetric pressure"
echo "1..$n"
