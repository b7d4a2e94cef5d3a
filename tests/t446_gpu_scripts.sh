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
tool=$2
shift 4
"$@" || exit
[ "$tool" = racecheck ] || exit 0
echo "========= Error: Race reported between Write access at $RACES::scan(int)+0x450"
echo "=========     and Read access at $RACES::scan(int)+0x4a0 [64 hazards]"
exit 9
EOF
chmod +x "$work/bin/compute-sanitizer"
PATH=$work/bin:$PATH
short() { SCENES="scenes/validation/free-fall.json" SHORT=0.001 RACES=$2 BUILD=$1 sh tests/gpu-states.sh >"$work/out" 2>&1; }
passed() { grep -c '^ok' "$work/out"; }
failed() { grep -c '^not ok' "$work/out"; }
whole() { [ "$(tail -n 1 "$work/out")" = "1..$(($(passed) + $(failed)))" ]; }

short "$model" "void cub::CUDA_130000_SM_900"
whole && [ "$(failed)" = 0 ] && [ "$(passed)" -ge 53 ]
result $? "make test-gpu: $(passed) pass"

# Another gravity on the GPU, and races: no state and no picture is the same.
mkdir "$work/wrong"
cat >"$work/wrong/sph-render" <<EOF
#!/bin/sh
case "\$*" in
*"--backend cuda"*) set -- "\$@" --backend cpu --set "gravity=[0, -8, 1]" ;;
esac
exec "$model/sph-render" "\$@"
EOF
chmod +x "$work/wrong/sph-render"
short "$work/wrong" kernel
whole && [ "$(grep -c '^not ok .* states$' "$work/out")" -ge 18 ] && ! grep -q '^ok .* states$' "$work/out" &&
    ! grep -q '^ok .* renderer' "$work/out" && [ "$(grep -c '^not ok .* racecheck' "$work/out")" = 5 ]
result $? "make test-gpu with wrong states: $(failed) fail"

OUT=$work/bench SIZES="50k:0.1" MILLION=0.1 SUPPORTS=2.0 STEPS=1 SEEDS="" FRAMES=2 PICTURE=64x36 BUDGET=0.01s BUILD=$model \
    sh tests/gpu-bench.sh >"$work/out" 2>&1
films=$(if "$SPH" list encoders | grep -q '^ *mp4 .*not in this build'; then echo 1; else echo 2; fi)
renderers=$(if "$SPH" list renderers | grep -q '^ *egl .*not in this build'; then echo 2; else echo 3; fi)
! grep failed "$work/out" | grep -qv '^a film by' && [ "$(grep -c '^| [a-z0-9.-]* | cuda |' "$work/bench/summary.md")" = 3 ] &&
    [ "$(grep -c '^- .* a step)' "$work/bench/summary.md")" = 3 ] && grep -q 'S0, RTX 3070' "$work/bench/summary.md" &&
    [ "$(grep -c '^- .*: wall .*, draw ' "$work/bench/summary.md")" = $((films * renderers)) ]
result $? "make bench-gpu: tables of steps, passes and films"
"$model/sph-render" -v scenes/dambreak.json --set particles.spacing=0.1 --end 0.01 --size 64x36 --backend cuda \
    -o "$work/f-%d.png" >"$work/out" 2>&1
grep -q '^renderer cuda (a model of a GPU)' "$work/out" && ! grep -q 'passed over' "$work/out"
result $? "auto draws by cuda on a GPU with few graphics units"
echo "1..$n"
