#!/bin/sh
# Tests that implicit viscosity gives the same bits for any number of threads, instruction set and
# neighbour search.
. tests/tap.sh
export OMP_WAIT_POLICY=passive

states() {
    "$SPH" -q tests/scenes/honey.json "$@" -o null --report "$work/report.json" 2>"$work/out" || return 1
    jq -r '.frames[] | "\(.time) \(.state)"' "$work/report.json"
}
same() { # NAME ARGUMENTS...
    name=$1
    shift
    states "$@" >"$work/next"
    cmp "$work/first" "$work/next" >>"$work/out" 2>&1
    result $? "the same $name"
}

states --threads 1 >"$work/first"
jq -e '.solves.viscosity.sweeps > 100 and .solves.viscosity.unsolved == 0' "$work/report.json" >"$work/out"
result $? "viscosity is solved for: $(jq -c .solves.viscosity "$work/report.json")"
[ "$(sort -u -k2 "$work/first" | wc -l)" -ge 10 ]
result $? "$(jq .particles "$work/report.json") particles, $(jq .steps "$work/report.json") steps"
same "on 2 threads" --threads 2
same "on 3 threads" --threads 3
same "with all-pairs" --threads 2 --set neighbours=all-pairs
for isa in scalar avx2 avx512; do
    if [ $isa != scalar ] && ! grep -qwE "$isa|${isa}f" /proc/cpuinfo; then
        echo "# $isa: this processor does not have it"
        continue
    fi
    same "with --isa $isa" --threads 1 --isa $isa
done
echo "1..$n"
