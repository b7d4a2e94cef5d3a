#!/bin/sh
# Tests what is said before and when a run fails: --strict, memory, threads, no particles.
. tests/tap.sh
export OMP_WAIT_POLICY=passive
cat >"$work/scene.json" <<'J'
{ "domain": {"min": [0, 0, 0], "max": [0.5, 0.5, 0.3]}, "particles": {"spacing": 0.05},
  "fluids": [{"density": 1000, "viscosity": 1e-3}],
  "bodies": [{"shape": "box", "min": [0, 0.1, 0], "max": [0.25, 0.4, 0.3]}],
  "time": {"end": 0.2}, "movie": {"size": [64, 64], "fps": 10} }
J
grep -v bodies "$work/scene.json" >"$work/none.json"
# says CODE TEXT NAME ARGUMENTS...
says() {
    code=$1 text=$2 name=$3
    shift 3
    timeout 60 "$SPH" "$@" >"$work/out" 2>&1
    rc=$?
    [ $rc = "$code" ] && grep -qE -e "$text" "$work/out"
    result $? "$name: exit code $code"
}
run="$work/scene.json -o null --threads 1"
for s in wcsph dfsph muller; do
    case $s in wcsph) step=5.5e-4 ;; dfsph) step=6e-3 ;; muller) step=4.2e-4 ;; esac
    says 1 "strict: at t = 0 s the .* limit .* asks for" "$s, strict, a long step" \
        $run --strict --solver $s --set time.step=0.05
    says 0 frames "$s, strict, a short step" $run --strict --solver $s --set time.step=1e-4
    says 1 "strict: at t = 0[.][0-9]*[1-9]" "$s, strict, during the run" $run --strict --solver $s \
        --set time.step=$step --set time.end=1
done
# A drop of water whose sound is so slow that surface tension asks for the shortest step, 2e-4 s.
cat >"$work/drop.json" <<'J'
{ "domain": {"min": [0, 0, 0], "max": [5e-3, 5e-3, 3e-3]}, "particles": {"spacing": 5e-4},
  "fluids": [{"density": 1000, "viscosity": 1e-3, "surface_tension": 0.07}],
  "bodies": [{"shape": "box", "min": [1e-3, 1e-3, 1e-3], "max": [3e-3, 3e-3, 2e-3]}],
  "solver": {"method": "wcsph", "sound_speed": 0.45}, "time": {"end": 0.001}, "movie": {"size": [64, 64], "fps": 1000} }
J
says 1 "strict: at t = 0 s the capillary limit .* asks for a step of 0.0001975 s" "capillary, strict" \
    "$work/drop.json" -o null --strict --set time.step=5e-4
says 0 "time step .*capillary 0.0001975" "capillary, plan" \
    "$work/drop.json" --plan --set time.step=5e-4
says 0 frames "capillary, a longer step is shortened" "$work/drop.json" -o null --report "$work/drop" \
    --set time.step=5e-4
jq -e '.dt.max > 1.6e-4 and .dt.max <= 1.976e-4' "$work/drop" >"$work/out"
result $? "capillary: the longest step is $(jq .dt.max "$work/drop") s"
says 2 "gives no time.step" "strict without a step" $run --strict
for how in --check --plan "-o null"; do
    says 1 "GB .*use a spacing of" "too much memory, $how" scenes/dambreak.json \
        --set particles.spacing=0.00035 $how
    says 2 "4294967294 can be numbered" "too many particles, $how" scenes/dambreak.json \
        --set particles.spacing=0.00025 $how
done
says 0 "warning: 256 threads on" "threads beyond the processors" "$work/none.json" -o null \
    --threads 256
says 0 "no particles" "no particles" "$work/none.json" -o null
! grep -q "sound speed" "$work/out"
result $? "no particles: no sound speed is said"
says 0 "particles      0" "no particles, plan" "$work/none.json" --plan
! grep -q "sound speed\|time step" "$work/out"
result $? "no particles, plan: no sound speed, no step"
echo "1..$n"
