#!/bin/sh
# Tests runs from outside: no particle, one, two; --at; interruption; the report.
. tests/tap.sh
export OMP_WAIT_POLICY=passive
cat >"$work/none.json" <<'X'
{ "gravity": [0, -9.81, 0], "domain": {"min": [0, 0, 0], "max": [1, 1, 1]},
  "particles": {"spacing": 0.05}, "fluids": [{"name": "water"}], "bodies": [],
  "time": {"end": 0.2}, "movie": {"size": [64, 64], "fps": 10} }
X
one='[{"shape": "box", "min": [0.5, 0.5, 0.5], "max": [0.55, 0.55, 0.55]}]'
two='[{"shape": "box", "min": [0.5, 0.5, 0.5], "max": [0.6, 0.55, 0.55]}]'
jq ".bodies = $one" "$work/none.json" >"$work/one.json"
jq ".bodies = $two" "$work/none.json" >"$work/two.json"

# report JQ-TEST NAME
report() {
    jq -e "$1" "$work/report.json" >"$work/out" 2>&1
    result $? "$2"
}
for k in none one two; do
    for solver in wcsph muller; do
        "$SPH" -q "$work/$k.json" --solver $solver -o null --report "$work/report.json" >"$work/out" 2>&1
        result $? "$k, $solver"
        case $k in none) wanted=0 ;; one) wanted=1 ;; *) wanted=2 ;; esac
        report ".particles == $wanted and (.frames | length) == 3 and .rejected == 0" \
            "$k, $solver: particles and frames"
    done
done

"$SPH" -q scenes/dambreak.json --set particles.spacing=0.05 --at 0.123456789 -o null \
    --report "$work/report.json" >"$work/out" 2>&1
report '(.frames | length) == 1 and .frames[0].time == 0.123456789' "--at is met exactly"
report '.steps > 0 and .dt.min <= .dt.mean and .dt.mean <= .dt.max' "dt statistics"
report '.pairs > 0 and .ns_per_particle_step > 0' "pairs, ns per particle and step"
report '(.seconds | has("wall") and has("solve") and has("draw") and has("encode") and has("stencil")
         and has("sort") and has("neighbours") and has("product") and has("drift"))' "time by phase"
report '.frames[0].state | test("^[0-9a-f]{16}$")' "state hash"
report '(.machine.processor | length) > 0 and .machine.processors > 0' "machine"
report '(.program | test("^sph-render [0-9]")) and (.compiler | length) > 0' "versions"
report '.backend | test("^cpu \\(")' "back end"
report '.scene.particles.spacing == 0.05 and .scene.solver.method == "isph"' "effective scene"
jq .scene "$work/report.json" >"$work/scene.json"
"$SPH" "$work/scene.json" --check >"$work/out" 2>&1
result $? "the scene of the report loads"
"$SPH" -q "$work/one.json" -o null --report "$work/no/such/place.json" >"$work/out" 2>&1
[ $? = 4 ]
result $? "a report that cannot be written is exit code 4"

# interrupt OUT: ends a run of hours by SIGINT; its exit code is in $rc
interrupt() {
    "$SPH" -q scenes/dambreak.json --set particles.spacing=0.03 --end 3000 --fps 100 --size 64x64 \
        --threads 1 -o "$1" >"$work/out" 2>&1 &
    pid=$!
    sleep 3
    kill -INT $pid
    wait $pid
    rc=$?
}
interrupt null
[ $rc = 130 ]
result $? "SIGINT ends a run with 130 (got $rc)"
if "$SPH" list encoders | grep -q mp4 && "$SPH" list renderers | grep -qE 'egl|osmesa'; then
    interrupt "$work/film.mp4"
    [ $rc = 130 ] && [ -s "$work/film.mp4" ] && [ ! -e "$work/film.mp4.part" ]
    result $? "SIGINT finishes the film (got $rc)"
    if command -v ffprobe >/dev/null; then
        ffprobe -v error -count_frames -show_entries stream=nb_read_frames -of csv=p=0 \
            "$work/film.mp4" >"$work/frames" 2>"$work/out"
        [ "$(tr -dc 0-9 <"$work/frames")" -ge 1 ] && [ ! -s "$work/out" ]
        result $? "which plays, $(cat "$work/frames") frames"
    fi
fi
echo "1..$n"
