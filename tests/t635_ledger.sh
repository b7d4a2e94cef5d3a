#!/bin/sh
# Tests ledgers: rows of features that a scene leaves out, their proofs, and that a proof can fail.
. tests/tap.sh
cat >"$work/scene.json" <<'J'
{ "gravity": [0, -9.81, 0], "domain": {"min": [0, 0, 0], "max": [0.5, 0.5, 0.5]},
  "particles": {"spacing": 0.05}, "fluids": [{"density": 1000, "viscosity": 0}],
  "bodies": [{"shape": "box", "min": [0, 0, 0], "max": [0.25, 0.25, 0.5]}],
  "solver": {"method": "wcsph", "artificial_viscosity": 0, "diffusion": 0},
  "time": {"end": 0.2}, "movie": {"size": [320, 180], "fps": 20} }
J
ledger() { # DIRECTORY ARGUMENTS...
    directory=$1
    shift
    "$SPH" study -q --ledger "$work/scene.json" -o "$work/$directory" --steps 10 --repeats 2 "$@"
}
# row DIRECTORY FEATURE FILTER
row() {
    jq -e --arg name "$2" ".features[] | select(.name == \$name) | $3" "$work/$1/ledger.json" >>"$work/out"
}
ledger plain >"$work/out" 2>&1
result $? "a ledger is made"
tail -n +1 "$work/plain/ledger.md" | cmp - "$work/out" >/dev/null
result $? "its table is on standard output, too"
for name in surface occlusion shadow outline "scale bar" axes labels; do
    row plain "$name" '.kind == "left out" and .off_state == "same" and .on_state == "same" and .proved and
        .without > 0 and (.changes_pictures or .name == "occlusion")'
    result $? "$name: without it pictures are the same, with it the state"
done
row plain legend '.kind == "used"'
result $? "a look that the scene uses is no row"
jq -e '[.features[] | select(.kind == "left out") | .proved] | length >= 12 and all' \
    "$work/plain/ledger.json" >>"$work/out"
result $? "the absence of everything left out is proved"
for name in viscosity "artificial viscosity" "density diffusion" "surface tension" dissipation; do
    row plain "$name" '.off_state == "same" and .on_state == "different" and .passes_absent'
    result $? "$name: off is the same, on is another state"
done
row plain "surface tension" '.plan_says == "passes of surface tension: every fluid has surface tension 0"'
result $? "the plan's words are told"
row plain viscosity '.faint_state == "same"'
result $? "vanishing viscosity is the same state"
row plain "surface tension" '.with > .without and .bytes_by_plan == 16'
result $? "surface tension costs time and memory"
row plain buoyancy '.on_state == "same"'
result $? "buoyancy of one fluid does nothing, and the ledger says so"
row plain "implicit viscosity" '.kind == "cannot be switched on" and (.reason | test("isph"))'
result $? "what the method has not is listed with the reason"
for name in "measured rows" drawing vorticity; do
    row plain "$name" '.kind == "cannot be switched on" or (.on_state == "same" and .with > 0)'
    result $? "$name leaves the state as it is"
done
[ "$(wc -l <"$work/plain/ledger.csv")" = $(($(jq '.features | length' "$work/plain/ledger.json") + 1)) ]
result $? "a line of csv for each"

# The proof can fail: a scene that uses what another leaves out ends in another state.
ledger thick --set fluids.0.viscosity=1 >"$work/out" 2>&1
row thick viscosity '.kind == "used"'
result $? "what the scene uses is no row"
[ "$(jq -r .state "$work/plain/ledger.json")" != "$(jq -r .state "$work/thick/ledger.json")" ]
result $? "and its state is another"

refused() { # NAME PATTERN ARGUMENTS...
    name=$1 pattern=$2
    shift 2
    "$SPH" study "$@" -o "$work/none" >"$work/out" 2>&1
    [ $? = 2 ] && grep -q "$pattern" "$work/out" && [ ! -e "$work/none" ]
    result $? "$name"
}
sed 's/"density"/"dnsity"/' "$work/scene.json" >"$work/bad.json"
refused "a bad scene is told by its place" 'bad.json:2:[0-9]*:.*density' --ledger "$work/bad.json"
sed 's/"max": \[0.25, 0.25, 0.5\]/"max": [0.01, 0.01, 0.01]/' "$work/scene.json" >"$work/empty.json"
refused "a scene without particles is refused" 'empty.json:.*particle' --ledger "$work/empty.json"
sed 's/{"shape": "box".*}\]/]/' "$work/scene.json" >"$work/bodiless.json"
refused "so is one without bodies" 'bodiless.json.*\(particle\|bod\)' --ledger "$work/bodiless.json"
refused "--set is of ledgers" 'are of --ledger' --set a=1 studies/free-fall.json
echo "1..$n"
