# Shared by the tests of same bits: runs a scene in every way that must not matter, and compares hashes
# of the state of every frame.
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

# same WHAT PROGRAM ARGUMENTS...: the states of $work/first
same() {
    what=$1
    shift
    states "$@" >"$work/next" && cmp "$work/first" "$work/next" >>"$work/out" 2>&1
    result $? "$name: the same $what"
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

isas=
for isa in $("$SPH" list isas | awk '{print $1}' | grep -E '^(scalar|avx2|avx512)$'); do
    if [ "$isa" = scalar ] || grep -qwE "$isa|${isa}f" /proc/cpuinfo; then
        isas="$isas $isa"
    else
        echo "# $isa: this processor does not have it"
    fi
done

# compare NAME SCENE ARGUMENTS...: the first states must satisfy `worth`, a jq test of the report, and
# differ in $least frames
compare() {
    name=$1
    shift
    states "$SPH" "$@" --threads 1 >"$work/first"
    jq -e "$worth" "$work/report.json" >"$work/out" &&
        [ "$(sort -u -k2 "$work/first" | wc -l)" -ge "$least" ]
    result $? "$name: $(jq -r '"\(.particles) particles, \(.steps) steps"' "$work/report.json")"
    own=$(jq -r .backend "$work/report.json") # "cpu (avx512, 1 thread)"
    for threads in 2 7; do
        same "on $threads threads" "$SPH" "$@" --threads $threads
    done
    for isa in $isas; do
        case $own in *"($isa,"*) continue ;; esac # the first states are its
        same "with --isa $isa" "$SPH" "$@" --threads 2 --isa "$isa"
    done
    same "with all-pairs" "$SPH" "$@" --threads 2 --set neighbours=all-pairs
    [ -n "$second" ] || return
    for isa in scalar auto; do
        same "from $other, --isa $isa" "$second" "$@" --threads 2 --isa $isa
    done
}
