#!/bin/sh
# Tests make test-gpu and make bench-gpu by the program on a model of a GPU, shortened: they run to their ends and
# find nothing, and a wrong state is found.
. tests/tap.sh
: "${BUILD:=build}"
model=$BUILD/model
if [ ! -x "$model/sph-render" ]; then
    echo "ok 1 - # SKIP this build has no CUDA"
    echo "1..1"
    exit 0
fi
mkdir "$work/bin"
cat >"$work/bin/compute-sanitizer" <<'EOF'
#!/bin/sh
[ "$1 $3 $4" = "--tool --error-exitcode 9" ] || exit 9
shift 4
exec "$@"
EOF
chmod +x "$work/bin/compute-sanitizer"
PATH=$work/bin:$PATH
short() { SCENES="scenes/validation/free-fall.json" SHORT=0.001 BUILD=$1 sh tests/gpu-states.sh >"$work/out" 2>&1; }
passed() { grep -c '^ok' "$work/out"; }
failed() { grep -c '^not ok' "$work/out"; }
whole() { [ "$(tail -n 1 "$work/out")" = "1..$(($(passed) + $(failed)))" ]; }

short "$model"
whole && [ "$(failed)" = 0 ] && [ "$(passed)" -ge 53 ]
result $? "make test-gpu: $(passed) pass"

# Another gravity on the GPU: no state and no picture is the same.
mkdir "$work/wrong"
cat >"$work/wrong/sph-render" <<EOF
#!/bin/sh
case "\$*" in
*"--backend cuda"*) set -- "\$@" --backend cpu --set "gravity=[0, -8, 1]" ;;
esac
exec "$model/sph-render" "\$@"
EOF
chmod +x "$work/wrong/sph-render"
short "$work/wrong"
whole && [ "$(grep -c '^not ok .* states$' "$work/out")" -ge 18 ] && ! grep -q '^ok .* states$' "$work/out" &&
    ! grep -q '^ok .* renderer' "$work/out"
result $? "make test-gpu with wrong states: $(failed) fail"

OUT=$work/bench SIZES="50k:0.1" MILLION=0.1 SUPPORTS=2.0 STEPS=1 SEEDS="" FRAMES=2 PICTURE=64x36 BUDGET=0.01s BUILD=$model \
    sh tests/gpu-bench.sh >"$work/out" 2>&1
films=$(if "$SPH" list encoders | grep -q '^ *mp4 .*not in this build'; then echo 1; else echo 2; fi)
renderers=$(if "$SPH" list renderers | grep -q '^ *egl .*not in this build'; then echo 2; else echo 3; fi)
! grep failed "$work/out" | grep -qv '^a film by' && [ "$(grep -c '^| [a-z0-9.-]* | cuda |' "$work/bench/summary.md")" = 3 ] &&
    [ "$(grep -c '^- .* a step)' "$work/bench/summary.md")" = 3 ] && grep -q 'S0, RTX 3070' "$work/bench/summary.md" &&
    [ "$(grep -c '^- .*: wall .*, draw ' "$work/bench/summary.md")" = $((films * renderers)) ]
result $? "make bench-gpu: tables of steps, passes and films"
echo "1..$n"
