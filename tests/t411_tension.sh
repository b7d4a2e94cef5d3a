#!/bin/sh
# Tests surface tension: pressure in a drop (Laplace), momentum, the same bits, refusal by dfsph.
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
