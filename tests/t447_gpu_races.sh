#!/bin/sh
# Tests that no two threads of a kernel use the same memory without a barrier between them, one of them to write:
# ThreadSanitizer watches the .cu files on the model of a GPU.
. tests/tap.sh
: "${BUILD:=build}"
races=$BUILD/races/sph-render
export OMP_NUM_THREADS=1 TSAN_OPTIONS="exitcode=9 history_size=4"
still=
setarch -R true 2>"$work/out" && still="setarch -R" # its shadow has a place of its own
if [ ! -x "$races" ] || ! $still "$races" list devices >"$work/out" 2>&1; then
    sed 's/^/# /' "$work/out"
    echo "ok 1 - # SKIP the program is not built with CUDA and ThreadSanitizer, or cannot start"
    echo "1..1"
    exit 0
fi

# watched ARGUMENTS...: leaves what was found in $work/out
watched() {
    rm -f "$work/report.json"
    $still "$races" -q "$@" --threads 1 --backend cuda --renderer cuda --size 80x45 -o hash --report "$work/report.json" \
        >"$work/hashes" 2>"$work/out"
    [ $? = 0 ] && ! grep -q ThreadSanitizer "$work/out"
}
# clean NAME ARGUMENTS...
clean() {
    name=$1
    shift
    watched "$@" && jq -e '.steps > 1' "$work/report.json" >"$work/steps"
    result $? "$name: $(jq .steps "$work/report.json") steps"
}
clean "two fluids" tests/scenes/two-fluids.json --end 0.001 --fps 1000
clean "wall particles, shifting" tests/scenes/wall-particles.json --set solver.shifting=on --end 0.002 --fps 500
clean "diffusion by gradients, vorticity" tests/scenes/dam.json --set solver.diffusion_form=antuono --color vorticity \
    --end 0.002 --fps 500
clean "muller" scenes/muller-splash.json --set particles.spacing=0.1 --end 0.004 --fps 250
clean "dfsph" scenes/dambreak.json --set 'solver={"method": "dfsph"}' --set particles.spacing=0.1 --end 0.03
clean "dfsph, thick" tests/scenes/honey.json --end 0.006 --fps 250
clean "isph" scenes/dambreak.json --set particles.spacing=0.1 --end 0.03
clean "isph, wall particles" tests/scenes/projection-wall-particles.json --end 0.012 --fps 250
clean "drop in another fluid" tests/scenes/drop-in-fluid.json --end 0.001 --fps 1000
GPU_MODEL_NO_BARRIERS=1 watched scenes/dambreak.json --set particles.spacing=0.1 --end 0.01
[ $? != 0 ] && [ -s "$work/report.json" ] && grep -q 'data race' "$work/out"
result $? "without barriers races are found: $(grep -c 'data race' "$work/out")"
echo "1..$n"
