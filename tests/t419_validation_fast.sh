#!/bin/sh
# Tests coarse validation cases against exact solutions and experiments: a bound for each error, about
# twice what is measured. Finer ones: make study. First the measuring itself, of exact start states.
. tests/tap.sh
export OMP_WAIT_POLICY=passive

# start SCENE MEASURE COLUMN VALUE BOUND: the column's first value
start() {
    "$SPH" "scenes/validation/$1.json" --set "measure=[$2]" --end 0.0001 -o "$work/rows.csv" -q \
        --set movie.start=0.0001 >"$work/out" 2>&1
    awk -F, -v name="$3" -v value="$4" -v bound="$5" '
        NR == 1 { for (k = 1; k <= NF; k++) if (index($k, name " (") == 1 || $k == name) c = k }
        NR == 2 { found = c ? $c : "nothing"; e = found - value; if (e < 0) e = -e
                  if (value != 0) e /= value > 0 ? value : -value }
        END { print name, found, "error", e; exit !(c && e <= bound) }' "$work/rows.csv" >>"$work/out"
    result $? "$1 as it starts, $(tail -n 1 "$work/out"), at most $5"
}
start taylor-green-jitter '{"quantity": "flow-error", "flow": "taylor-green"}' flow-error.speed 0 1e-6
start beltrami '{"quantity": "flow-error", "flow": "beltrami"}' flow-error.velocity 0 1e-6
start standing-wave '{"quantity": "wave", "wavelength": 2}' wave.cosine 0 1e-9
start martin-moyce '{"quantity": "front"}' front.position 0.05715 1e-6
start martin-moyce '{"quantity": "height", "at": [0, 0, 0.025]}' height 0.1143 1e-6
start hydrostatic-20 '{"quantity": "pressure", "at": [0.25, 0.5, 0.25], "radius": 0.1}' pressure 4905 1e-6
start column-100m '{"quantity": "pressure", "at": [7.5, 50, 7.5], "radius": 5}' pressure 490500 1e-6

"$SPH" study tests/studies/*.json -o "$work/studies" --repeats 1 -q >"$work/out" 2>&1
result $? "the studies run"
# bound STUDY NAME BOUND: all errors of the study whose names begin so
while read -r study bound name; do
    jq -r --arg name "$name" --argjson bound "$bound" '[.points[0].errors[] |
        select(.name | startswith($name))] | map("\(.name) \(.value)"), "good \(length > 0 and
        all(.value | fabs <= $bound))"' "$work/studies/$study/results.json" >"$work/out" 2>&1
    grep -q '^good true' "$work/out"
    result $? "$study: $(grep -v '^good' "$work/out" | tr -d '[]",\n' | tr -s ' '), at most $bound"
done <<'X'
free-fall 2e-7 height
poiseuille 0.015 velocity
couette 0.015 velocity
taylor-green-jitter 0.02 kinetic energy at
taylor-green-jitter 0.012 speed
beltrami 0.036 kinetic energy at
beltrami 0.02 speed
elliptic-drop 0.005 semi-axis along
elliptic-drop 0.032 short semi-axis by moments
elliptic-drop 0.032 long semi-axis by moments
elliptic-drop 0.024 kinetic energy
oscillating-drop 0.02 period
oscillating-drop 0.036 first amplitude
oscillating-drop 0.13 amplitude, change
standing-wave 0.02 frequency, of sqrt
standing-wave 0.016 amplitude
hydrostatic-20-thick 0.013 pressure, L2
hydrostatic-20-thick 0.006 pressure on
hydrostatic-20-thick 0.004 volume
hydrostatic-20-thick 0.008 mass centre
hydrostatic-20-thick 3.6e-5 kinetic energy
X
echo "1..$n"
