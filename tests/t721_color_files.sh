#!/bin/sh
# Tests colours of whole runs: own maps beside the scene, steps, ranges by frame, messages.
. tests/tap.sh
mkdir "$work/maps"
cat >"$work/scene.json" <<'X'
{ "domain": {"min": [0, 0, 0], "max": [0.5, 0.5, 0.5]}, "particles": {"spacing": 0.05},
  "fluids": [{"density": 1000}], "time": {"end": 0.1}, "movie": {"size": [64, 64], "fps": 20},
  "bodies": [{"shape": "box", "min": [0, 0, 0], "max": [0.25, 0.25, 0.5]}] }
X
printf '#000000\n#ff8000\n' >"$work/maps/fire.txt"
printf '0 0 0\n1 one 0\n' >"$work/maps/wrong.txt"
plan() {
    "$SPH" "$work/scene.json" --plan -o hash "$@" >"$work/plan" 2>"$work/out"
}
# says TEXT NAME: the plan's line of colour
says() {
    grep '^colour' "$work/plan" >>"$work/out"
    grep '^colour' "$work/plan" | grep -qF -e "$1"
    result $? "$2"
}
plan --set color.map_file=maps/fire.txt
result $? "a map beside the scene file is found from anywhere"
cp "$work/maps/fire.txt" "$work/fire.txt"
plan --set color.map_file="$work/fire.txt"
result $? "and one with an absolute path"
for check in "--check -o hash" "-o $work/film.mp4"; do
    "$SPH" "$work/scene.json" $check --set color.map_file=maps/wrong.txt >"$work/out" 2>&1
    [ $? = 2 ] && grep -q "maps/wrong.txt:2:3: not a number" "$work/out" && [ -z "$(ls "$work"/film* 2>/dev/null)" ]
    result $? "a wrong one is told with its place, and nothing is written: $check"
done
plan --set color.map_file=none.txt
[ $? = 2 ] && grep -q "none.txt: cannot be read" "$work/out"
result $? "a missing one too"

plan --color velocity.x
says "x-velocity, -2.215 to 2.215 m/s" "a component is symmetric about zero"
plan --set color.scale=symmetric --set 'color.range=[-1, 3]'
says "speed, -3 to 3 m/s" "symmetric widens a range"
plan --set color.scale=log --set 'color.range=[0.01, 3]'
says "logarithmic" "log"
plan --set color.scale=log
says "0.002215 to 2.215 m/s" "three powers of ten where the estimate begins at 0"
plan --set color.steps=6
says "0 to 2.4 m/s" "steps of an estimated range are round"
says "6 colours" "and counted"
plan --color body
says "-0.5 to 0.5 (a colour for each body), 1 colours" "one body, one colour"
plan --set 'color.percentiles=[1, 99]'
says "in each frame from its percentile 1 to 99" "a range by frame only when asked for"

if "$SPH" list renderers | grep -q cpu; then
    pixels() {
        "$SPH" -q "$work/scene.json" --at 0.1 -o hash "$@" 2>"$work/out" | tail -n 1 | awk '{print $4}'
    }
    one=$(pixels) two=$(pixels --set color.reverse=true) three=$(pixels --set color.reverse=true --set color.map=viridis)
    [ -n "$one" ] && [ "$one" != "$two" ] && [ "$two" = "$three" ]
    result $? "a reversed map is another"
    all=$(pixels --set 'color.percentiles=[0, 100]') most=$(pixels --set 'color.percentiles=[20, 60]')
    [ -n "$all" ] && [ "$all" != "$most" ] && [ "$all" != "$one" ]
    result $? "percentiles are drawn"
    for color in $("$SPH" list colors | awk 'NR > 1 {print $1}'); do
        [ -n "$(pixels --color "$color")" ]
        result $? "$color is drawn"
    done
fi
echo "1..$n"
