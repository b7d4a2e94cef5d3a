#!/bin/sh
# Tests stability maps: what becomes of a cell, curves, resuming, bad input, gnuplot missing.
. tests/tap.sh
cat >"$work/scene.json" <<'J'
{ "gravity": [0, -9.81, 0], "domain": {"min": [0, 0, 0], "max": [0.5, 0.5, 0.5]},
  "particles": {"spacing": 0.05}, "fluids": [{"density": 1000, "viscosity": 0}],
  "bodies": [{"shape": "box", "min": [0, 0, 0], "max": [0.25, 0.25, 0.5]}],
  "solver": {"method": "wcsph"}, "time": {"end": 0.2}, "movie": {"size": [64, 64], "fps": 20} }
J
# study FILE BOUND SPEEDS MORE
study() {
    cat >"$work/$1" <<J
{ "title": "It's stiff", "scene": "scene.json", "interval": 0.05, "measure": [{"quantity": "speed"}],
  "errors": [{"name": "too fast", "column": "speed", "norm": "rise", "reference": {"value": $2}, "asked": 0}],
  "map": {"x": {"name": "step", "set": {"time.step": [5e-4, 1e-2]}},
          "y": {"name": "sound", "set": {"solver.sound_speed": [$3]}}}$4 }
J
}
kinds() { jq -c '[.cells[].kind]' "$work/$1/stability.json"; }

study stiff.json 10 '2, 20' ''
"$SPH" study -q --stability "$work/stiff.json" -o "$work/stiff" >"$work/out" 2>&1
result $? "a map is made"
kinds stiff >>"$work/out"
[ "$(kinds stiff)" = '["stopped","stopped","stable","shortened"]' ]
result $? "soft fluid is stopped, short steps are stable, long ones shortened"
jq -e '.cells[0].why | test("acoustic")' "$work/stiff/stability.json" >/dev/null &&
    grep -q 'acoustic: flow faster' "$work/stiff/report.md"
result $? "the cause is told"
jq -e '.cells[3] | .bound_by == "acoustic" and .steps > 2 * .fewest_steps and .fewest_steps == 20' \
    "$work/stiff/stability.json" >/dev/null
result $? "and which limit shortened the steps"
# C h/(c + v) at rest: 0.25 * 0.065 / 20
jq -e '.cells[3].limits.acoustic - 0.25 * 0.065 / 20 | fabs < 1e-9' "$work/stiff/stability.json" >/dev/null
result $? "the acoustic limit is that of theory"
[ "$(wc -l <"$work/stiff/stability.csv")" = 5 ] && [ -s "$work/stiff/stability.gp" ] &&
    grep -q '^0\.[0-9]* 1 0.0008125' "$work/stiff/stability.dat"
result $? "table, script and curve are there"
if command -v gnuplot >/dev/null; then
    [ -s "$work/stiff/stability.png" ] && [ -s "$work/stiff/stability.svg" ] &&
        [ ! -s "$work/stiff/stability.log" ]
    result $? "so are the figures, without a word of gnuplot"
fi

grep -q '<title>Stability maps</title>' "$work/stiff/index.html" &&
    grep -q '^| It.s stiff | 2, 1, 1, 0, 0 |$\|^| It.s stiff | 1, 1, 2, 0, 0 |$' "$work/stiff/summary.md" &&
    ! grep -qE '(src|href)="?(https?:|/|\.)' "$work/stiff/index.html"
result $? "a page and a table are there, and ask for no other file"

cp "$work/stiff/stability.csv" "$work/before.csv"
find "$work/stiff/runs" -name '*.end' | sort | xargs stat -c '%n %Y %i' >"$work/ends"
"$SPH" study -q --stability "$work/stiff.json" -o "$work/stiff" >"$work/out" 2>&1
find "$work/stiff/runs" -name '*.end' | sort | xargs stat -c '%n %Y %i' | cmp - "$work/ends" >"$work/out" 2>&1 &&
    cmp "$work/before.csv" "$work/stiff/stability.csv" >>"$work/out" 2>&1
result $? "what is there is not run again"

study tight.json 0.01 20 ''
"$SPH" study -q --stability "$work/tight.json" -o "$work/tight" >"$work/out" 2>&1 &&
    [ "$(kinds tight)" = '["wrong","wrong"]' ] && grep -q 'too fast is .* bound 0 %' "$work/tight/report.md"
result $? "a measured error beyond its bound is wrong"
study late.json 10 20 ', "limit": 0.01'
"$SPH" study -q --stability "$work/late.json" -o "$work/late" >"$work/out" 2>&1 &&
    [ "$(kinds late)" = '["late","late"]' ]
result $? "a run beyond the limit of time is late"

mkdir "$work/bin"
PATH="$work/bin" "$(realpath "$SPH")" study --stability "$work/stiff.json" -o "$work/stiff" >"$work/out" 2>&1 &&
    grep -q 'gnuplot-nox' "$work/out"
result $? "without gnuplot its package is named, and the rest is written"

# refused NAME PATTERN ARGUMENTS...
refused() {
    name=$1 pattern=$2
    shift 2
    "$SPH" study "$@" -o "$work/none" >"$work/out" 2>&1
    [ $? = 2 ] && grep -q "$pattern" "$work/out" && [ ! -e "$work/none" ]
    result $? "$name"
}
refused "a map needs --stability" 'add --stability' "$work/stiff.json"
refused "--stability needs a map" 'has no "map"' --stability studies/free-fall.json
sed 's/"y":/"z":/' "$work/stiff.json" >"$work/bad.json"
refused "an unknown axis is told by its place" 'bad.json:4:11: there is no key "z"' --stability "$work/bad.json"
sed 's/, "asked": 0//' "$work/stiff.json" >"$work/bad.json"
refused "a map without bounds is refused" 'no error has a bound' --stability "$work/bad.json"
sed 's/solver.sound_speed/solver.sound_sped/' "$work/stiff.json" >"$work/bad.json"
refused "a mistyped key is told by its place" 'bad.json:4:64:.*sound_speed' --stability "$work/bad.json"
echo "1..$n"
