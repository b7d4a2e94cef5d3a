#!/bin/sh
# Tests surface tension: pressure in drops (Laplace), momentum, the same bits, refusal by dfsph.
. tests/tap.sh
export OMP_WAIT_POLICY=passive
scene=tests/scenes/drop-at-rest.json

"$SPH" -q $scene -o "$work/drop.csv" >"$work/out" 2>&1
result $? "a drop at rest runs"
# Mean of column 2 over the second half, against 2 sigma/R = 14 Pa.
error=$(awk -F, '!/^#/ && $1 + 0 >= 0.15 { s += $2; n++ } END { print s / n / 14 - 1 }' "$work/drop.csv")
awk "BEGIN { exit !($error > -0.10 && $error < 0.10) }"
result $? "pressure inside, 2 sigma/R: error $error"
# Columns 3 to 5: momentum, kg m/s; 4.2 g at 1 mm/s have 4e-6.
most=$(awk -F, '!/^#/ && NR > 1 { for (k = 3; k <= 5; k++) { a = $k < 0 ? -$k : $k; if (a > m) m = a } }
               END { print m + 0 }' "$work/drop.csv")
awk "BEGIN { exit !($most < 1e-8) }"
result $? "momentum stays: $most kg m/s"

# isph: R/d = 10; the mean of the last rows, since capillary waves of the lattice's steps go on.
"$SPH" -q $scene --set 'solver.method="isph"' -o "$work/drop.csv" >"$work/out" 2>&1
result $? "a drop at rest runs with isph"
error=$(awk -F, '!/^#/ && $1 + 0 >= 0.15 { s += $2; n++ } END { print s / n / 14 - 1 }' "$work/drop.csv")
awk "BEGIN { exit !($error > -0.06 && $error < 0.06) }"
result $? "isph: pressure inside, 2 sigma/R: error $error"
drift=$(awk -F, '!/^#/ { for (k = 6; k <= 8; k++) { a[k] = $k < 0 ? -$k : $k } }
              END { m = a[6] > a[7] ? a[6] : a[7]; print 0 + (m > a[8] ? m : a[8]) }' "$work/drop.csv")
awk "BEGIN { exit !($drift > -1e-4 && $drift < 1e-4) }"
result $? "isph: the mass centre moves by $drift m, less than d/10"
# The square has the area of a circle of radius 10.16 mm.
"$SPH" -q tests/scenes/drop-in-fluid.json -o "$work/drop.csv" >"$work/out" 2>&1
result $? "a drop in another fluid runs with isph"
error=$(awk -F, '!/^#/ { j = $2 - $3 } END { print j / (0.07 / 0.010155) - 1 }' "$work/drop.csv")
awk "BEGIN { exit !($error > -0.1 && $error < 0.1) }"
result $? "isph: jump of pressure between fluids, sigma/R: error $error"

states() {
    "$SPH" -q $scene --end 0.02 "$@" -o null --report "$work/report.json" 2>"$work/out" || return 1
    jq -r '.frames[] | "\(.time) \(.state)"' "$work/report.json"
}
states --threads 1 >"$work/first"
[ -s "$work/first" ]
result $? "states are written"
for how in "--threads 2" "--threads 3" "--isa scalar" "--isa avx2" "--set neighbours=all-pairs"; do
    states $how >"$work/next"
    cmp "$work/first" "$work/next" >>"$work/out" 2>&1
    result $? "the same bits with $how"
done
"$SPH" $scene --solver dfsph --check >"$work/out" 2>&1
[ $? = 2 ] && grep -q "dfsph has no surface tension" "$work/out"
result $? "dfsph refuses it"
echo "1..$n"
