#!/bin/sh
# Tests that no request wrecks a run silently: it ends finite and contained, or with exit code 1 and
# a message that names particle, time, cause and change. A step of the scene is an upper bound.
. tests/tap.sh
export OMP_WAIT_POLICY=passive
cat >"$work/scene.json" <<'X'
{ "gravity": [0, -9.81, 0], "domain": {"min": [0, 0, 0], "max": [0.5, 0.5, 0.3]},
  "particles": {"spacing": 0.05}, "fluids": [{"density": 1000, "viscosity": 1e-3}],
  "bodies": [{"shape": "box", "min": [0, 0, 0], "max": [0.25, 0.3, 0.3]}],
  "time": {"end": 0.2}, "movie": {"size": [64, 64], "fps": 10} }
X
run() {
    "$SPH" "$work/scene.json" -o null --threads 1 --report "$work/report.json" "$@" >"$work/out" 2>&1
}
# safe NAME ARGUMENTS...
safe() {
    name=$1
    shift
    rm -f "$work/report.json"
    timeout 60 "$SPH" "$work/scene.json" -o null --threads 1 --report "$work/report.json" "$@" \
        >"$work/out" 2>&1
    rc=$?
    if [ $rc = 0 ]; then
        jq -e '.particles == 180 and (.frames | length) == 3 and .dt.min > 0' \
            "$work/report.json" >/dev/null
        result $? "$name: finished in $(jq '"\(.steps) steps, \(.rejected) rejected"' -r "$work/report.json")"
    else
        grep -q 'particle [0-9]* at (' "$work/out" && grep -q 'stopped at t = ' "$work/out" &&
            grep -q 'cause: ' "$work/out" &&
            grep -qE 'raise|lower|separate|smaller|look for' "$work/out" && [ $rc = 1 ]
        result $? "$name: stopped with its cause (exit code $rc)"
    fi
}
safe "as it is"
safe "random start" --set bodies.0.fill=random
safe "random start, symmetric" --set bodies.0.fill=random --solver wcsph --set solver.pressure_form=symmetric
safe "random start, summed" --set bodies.0.fill=random --solver wcsph --set solver.density=summation
safe "random start, muller" --set bodies.0.fill=random --solver muller
safe "large jitter" --set bodies.0.jitter=0.5
safe "sound speed 1e-3" --solver wcsph --set solver.sound_speed=1e-3
safe "sound speed 1" --solver wcsph --set solver.sound_speed=1
safe "cfl 10" --set time.cfl=10
safe "stiffness 1e-6" --solver muller --set solver.stiffness=1e-6
safe "wall particles, random" --set domain.walls=particles --set bodies.0.fill=random
safe "impact at 110 m/s" --set 'bodies.0.velocity=[100, -50, 20]' 
safe "viscosity 10" --set fluids.0.viscosity=10
safe "density 1e-3" --set fluids.0.density=1e-3

run
free=$(jq .dt.max "$work/report.json")
run --set time.step=1e-4
jq -e '.dt.max <= 1e-4 and .steps >= 2000' "$work/report.json" >"$work/out"
result $? "time.step 1e-4 is an upper bound (free: $free)"
run --set time.step=1
jq -e --argjson free "$free" '.dt.max <= $free * 1.0001' "$work/report.json" >"$work/out"
result $? "time.step 1 does not loosen the stability limits"
echo "1..$n"
