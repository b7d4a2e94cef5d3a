#!/bin/sh
# Tests that states have the same bits for any number of threads, instruction set, compiler and
# neighbour search: state hashes of every frame, hundreds of steps beyond the first impact.
. tests/tap.sh
: "${BUILD:=build}" "${CC:=gcc}"
export OMP_WAIT_POLICY=passive

# states PROGRAM ARGUMENTS...: "time hash" of each frame
states() {
    program=$1
    shift
    "$program" -q "$@" -o null --report "$work/report.json" 2>"$work/out" || return 1
    jq -r '.frames[] | "\(.time) \(.state)"' "$work/report.json"
}

# The other compiler, without drawing and films, in its own directory.
case $CC in *clang*) other=gcc ;; *) other=clang ;; esac
second=$BUILD/$other/sph-render
if command -v $other >/dev/null; then
    env -u MAKEFLAGS -u MFLAGS make -j2 CC=$other BUILD="$BUILD/$other" OPT=-O2 CUDA=0 MPI=0 EGL=0 \
        OSMESA=0 LIBAV=0 CAIRO=0 all >"$work/out" 2>&1
    result $? "the program builds with $other"
else
    second=
    echo "# $other IS MISSING: compilers are not compared; install it and test again"
fi

isas=$("$SPH" list isas | awk '{print $1}' | grep -E '^(scalar|avx2|avx512)$')

# compare NAME SCENE ARGUMENTS...
compare() {
    name=$1
    shift
    states "$SPH" "$@" --threads 1 >"$work/first"
    steps=$(jq .steps "$work/report.json")
    particles=$(jq .particles "$work/report.json")
    [ "$steps" -ge 400 ] && [ "$(sort -u -k2 "$work/first" | wc -l)" -ge 10 ]
    result $? "$name: $particles particles, $steps steps on one thread"
    for threads in 2 3 7; do
        states "$SPH" "$@" --threads $threads >"$work/next"
        cmp "$work/first" "$work/next" >>"$work/out" 2>&1
        result $? "$name: the same on $threads threads"
    done
    for isa in $isas; do
        if ! grep -qw "$isa" /proc/cpuinfo && [ "$isa" != scalar ] &&
            ! grep -qw "${isa}f" /proc/cpuinfo; then
            echo "# $isa: this processor does not have it"
            continue
        fi
        states "$SPH" "$@" --threads 1 --isa "$isa" >"$work/next"
        cmp "$work/first" "$work/next" >>"$work/out" 2>&1
        result $? "$name: the same with --isa $isa"
    done
    states "$SPH" "$@" --threads 2 --set neighbours=all-pairs >"$work/next"
    cmp "$work/first" "$work/next" >>"$work/out" 2>&1
    result $? "$name: the same with all-pairs"
    [ -n "$second" ] || return
    for isa in scalar auto; do
        states "$second" "$@" --threads 2 --isa $isa >"$work/next"
        cmp "$work/first" "$work/next" >>"$work/out" 2>&1
        result $? "$name: the same from $other, --isa $isa"
    done
}

compare "dam break" scenes/dambreak.json --set particles.spacing=0.035 --end 1.6 --fps 15
compare "explicit dam break" tests/scenes/dam.json
compare "two fluids" tests/scenes/two-fluids.json
compare "two fluids, pressure midway" tests/scenes/two-fluids.json --set solver.pressure_form=average
compare "wall particles" tests/scenes/wall-particles.json
compare "muller" scenes/muller-splash.json --set particles.spacing=0.07 --end 0.8 --fps 30
compare "periodic" tests/scenes/periodic.json
compare "particle shifting" tests/scenes/taylor-green.json
compare "shifting between wall particles" tests/scenes/wall-particles.json --set solver.shifting=on
echo "1..$n"
