#!/bin/sh
# Tests that what a scene does not use costs nothing: no pass, no field, no memory, no library.
. tests/tap.sh
cat >"$work/scene.json" <<'X'
{ "gravity": [0, -9.81, 0], "domain": {"min": [0, 0, 0], "max": [0.5, 0.5, 0.5]},
  "particles": {"spacing": 0.05}, "fluids": [{"density": 1000, "viscosity": 0}],
  "bodies": [{"shape": "box", "min": [0, 0, 0], "max": [0.25, 0.25, 0.5]}],
  "solver": {"method": "wcsph", "artificial_viscosity": 0, "diffusion": 0},
  "time": {"end": 0.02}, "movie": {"size": [64, 64], "fps": 100}, "color": {"by": "velocity"} }
X
plan() { # ARGUMENTS...
    "$SPH" "$work/scene.json" --plan "$@" >"$work/plan" 2>"$work/out" || echo "exit code $?" >>"$work/out"
    cat "$work/plan" >>"$work/out"
}
has() { # TEXT NAME
    grep -qF -e "$1" "$work/plan"
    result $? "$2"
}
lacks() {
    ! grep -qF -e "$1" "$work/plan"
    result $? "$2"
}
# in_memory LABEL: bytes that a run reports
run_report() {
    "$SPH" -q "$work/scene.json" --report "$work/report.json" "$@" >"$work/out" 2>&1
}
bytes() { jq -r ".bytes.\"$1\" // 0" "$work/report.json"; }

plan -o null
has "term viscosity: every fluid" "viscosity 0 is left out"
has "term artificial viscosity" "artificial viscosity 0 is left out"
has "term density diffusion" "diffusion 0 is left out"
has "wall particles: no face" "wall particles are left out"
has "pass density" "continuity needs no density pass"
has "field fluid: one fluid" "one fluid needs no field"
has "field viscosity" "one viscosity needs no field"
has "drawing: no output" "no output, no drawing"
grep '^terms' "$work/plan" | grep -qx 'terms          pressure (average), continuity'
result $? "only pressure and continuity are summed"
lacks " fluid 1" "no memory for fluids is planned"
plan -o x.mp4
lacks "drawing: no output" "a film is drawn"
has "colour         " "and coloured"
plan -o null --set fluids.0.viscosity=0.1
grep '^terms' "$work/plan" | grep -q ', viscosity'
result $? "viscosity is planned where it is used"
plan -o null --set solver.density=summation
grep -q 'density     pair' "$work/plan"
result $? "summation has a density pass"
plan -o null --set domain.walls.-y=particles
has "wall particles" "wall particles are planned where they are used"
lacks "wall particles: no face" "and not left out"
sed '/"solver"/d' "$work/scene.json" >"$work/thick.json"
memory() { # ARGUMENTS...: fields of thick fluid, with the default solver
    "$SPH" "$work/thick.json" --plan -o null --set fluids.0.viscosity=1e4 "$@" 2>"$work/out" |
        grep '^memory' | tee -a "$work/out"
}
memory | grep -q ' search .* block '
result $? "viscosity along the line of centres has blocks"
memory --set 'solver.viscosity_form="morris"' | grep ' search ' | grep -qv ' block '
result $? "a Laplacian has none"
memory --set 'solver.viscosity="explicit"' | grep ' rate ' | grep -qvE ' (block|search|remainder) '
result $? "nor has explicit viscosity"

plan -o null --set solver.diffusion=0.1
has "passes gradient, diffusion: force adds" "Fourtakas's diffusion needs no passes"
lacks " gradient 16" "and no memory for gradients"
plan -o null --set solver.diffusion=0.1 --set solver.diffusion_form=antuono
grep -q ' gradient    pair' "$work/plan" && grep -q ' diffusion   pair' "$work/plan"
result $? "Antuono's has two"
has " gradient 16" "and memory"
plan -o null --set solver.diffusion_form=antuono
has "term density diffusion" "but not where diffusion is 0"
lacks " gradient 16" "nor memory"

plan -o hash
lacks "before each frame" "speed needs no pass before a frame"
lacks " vorticity 4" "nor memory"
plan -o hash --color vorticity
has "  1 curl " "vorticity has one"
has " vorticity 4" "and memory"
plan -o null --color vorticity
lacks "before each frame" "but not without frames"

# states ARGUMENTS...: the state's hashes, steps and sorts of a run
states() {
    run_report "$@" && jq -c '[.frames[].state], .steps, .sorts' "$work/report.json" >"$work/states"
}
states -o null && mv "$work/states" "$work/plain"
if "$SPH" list renderers | grep -q cpu; then
    states -o hash --color velocity && cmp "$work/plain" "$work/states" >"$work/out" 2>&1 &&
        jq -e '.seconds | has("curl") | not' "$work/report.json" >/dev/null
    result $? "drawing speed runs no curl, and leaves the state as it is"
    states -o hash --color vorticity && cmp "$work/plain" "$work/states" >"$work/out" 2>&1 &&
        jq -e '.seconds.curl > 0' "$work/report.json" >/dev/null
    result $? "drawing vorticity runs it, and leaves the state as it is"
fi

run_report -o null
result $? "a run without output"
jq -e '.bytes.position > 0 and .bytes.motion > 0' "$work/report.json" >/dev/null
result $? "fields are labelled in the report"
[ "$(bytes fluid)$(bytes viscosity)" = 00 ]
result $? "no memory for fluid and viscosity"
[ "$(bytes gradient)" = 0 ] && jq -e '.seconds | has("gradient") | not' "$work/report.json" >/dev/null
result $? "no memory and no time for density gradients"
[ "$(bytes 'kernel sums')" = 0 ]
result $? "no memory for sums of continuity"
jq -e '.wall_particles == 0 and (.seconds | has("density") | not)' \
    "$work/report.json" >/dev/null
result $? "no wall particles, no time in passes left out"
plain=$(bytes peak)
run_report -o null --set domain.walls=particles --set solver.density=summation
[ "$(bytes 'kernel sums')" -gt 0 ] && [ "$(bytes peak)" -gt "$plain" ]
result $? "wall particles and summation do take memory"
jq -e '.seconds | has("density")' "$work/report.json" >/dev/null
result $? "and time"

# Libraries that a run opens while it runs.
libraries() {
    LD_DEBUG=libs LD_DEBUG_OUTPUT="$work/ld" run_report "$@" || return 1
    cat "$work"/ld.* | grep 'calling init' | sed 's/.*: //' >"$work/out"
    rm -f "$work"/ld.*
}
libraries -o null && [ -s "$work/out" ] && ! grep -qE 'libEGL|libOSMesa|libGLX|libGL\.|swrast|gallium' "$work/out"
result $? "no GL library is opened without drawing"
if "$SPH" list renderers | grep -qE '^ *(egl|osmesa)'; then
    libraries -o "$work/f-%04d.png" && grep -qE 'libEGL|libOSMesa' "$work/out"
    result $? "and one is for a picture"
fi
echo "1..$n"
