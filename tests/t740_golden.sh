#!/bin/sh
# Tests frames of every style and colour against accepted ones: those of the cpu renderer exactly, those
# of OpenGL by the gate for other drivers. Without text, which depends on the machine's fonts.
# After a wanted change of frames: make, then UPDATE=1 tests/run t740_golden, and look at the pictures.
. tests/tap.sh
export OMP_WAIT_POLICY=passive
cat >"$work/scene.json" <<'X'
{ "gravity": [0, -9.81, 0], "domain": {"min": [0, 0, 0], "max": [1.2, 0.8, 0.5]},
  "particles": {"spacing": 0.05},
  "fluids": [{"name": "water", "density": 1000, "color": [0.16, 0.44, 0.8]},
             {"name": "oil", "density": 800, "color": [0.85, 0.6, 0.2]}],
  "bodies": [{"shape": "box", "min": [0, 0, 0], "max": [0.4, 0.5, 0.5], "fluid": "water"},
             {"shape": "box", "min": [0.8, 0, 0], "max": [1.2, 0.25, 0.5], "fluid": "oil"}],
  "time": {"end": 0.3}, "movie": {"size": [160, 90]}, "color": {"legend": false},
  "render": {"time": false, "title": false} }
X

# golden NAME ARGUMENTS...: what is drawn and the accepted frame are the same by $gate
golden() {
    name=$1
    shift
    "$SPH" -q "$work/scene.json" --at 0.2 "$@" -o "$work/$name.png" 2>"$work/out" || return 1
    if [ -n "${UPDATE:-}" ] && [ "$gate" = exact ]; then cp "$work/$name.png" "tests/golden/$name.png"; fi
    "$SPH" compare --gate $gate "$work/$name.png" "tests/golden/$name.png" >"$work/out" 2>&1
}

gate=exact
for color in $("$SPH" list colors | awk 'NR > 1 {print $1}'); do
    golden "color-$color" --renderer cpu --color "$color"
    result $? "color.by $color"
done
for map in $("$SPH" list maps | awk 'NR > 1 {print $1}'); do
    golden "map-$map" --renderer cpu --set color.map="$map" --set color.steps=6
    result $? "color.map $map in 6 steps"
done
looks="log:color.scale=log symmetric:color.scale=symmetric outline:render.outline=0.3
       transparent:render.transparent=true samples-1:render.samples=1 samples-4:render.samples=4
       surface:render.style=surface occlusion:render.occlusion=1 orthographic:camera.projection=orthographic
       large:render.radius=1 no-box:render.box=false faces:render.box=faces"
for look in $looks; do
    golden "${look%%:*}" --renderer cpu --set "${look#*:}"
    result $? "${look#*:}"
done
# floor STYLE RENDERER: with half of the fluid left out
floor() { golden "floor-$1" --renderer "$2" --set render.floor="$1" --set 'render.clip_max=[0.5, 9, 9]'; }
for style in none grid checker; do
    floor $style cpu
    result $? "render.floor=$style"
done
golden water --renderer cpu --set render.style=surface --color solid
result $? "water"
golden water-clear --renderer cpu --set render.style=surface --color solid --set render.transparent=true
result $? "water over nothing"
shadow() { golden shadow --renderer "$1" --set render.shadow=0.5; }
shadow cpu
result $? "render.shadow=0.5"
golden fading --renderer cpu --set 'render.background_top=[0.2, 0.3, 0.5]'
result $? "fading background"
golden cut --renderer cpu --set 'render.clip_max=[9, 0.2, 9]'
result $? "cut open"

solids='obstacles=[{"shape": "box", "min": [0.5, 0, 0.1], "max": [0.7, 0.2, 0.3], "color": [0.8, 0.4, 0.2]},
    {"shape": "sphere", "center": [0.3, 0.2, 0.25], "radius": 0.1}, {"shape": "cylinder", "center": [0.6, 0.4, 0.4],
    "radius": 0.08, "height": 0.8}, {"shape": "box", "min": [0.6, 0.1, 0.2], "max": [0.8, 0.3, 0.4]}]'
obstacles() { golden obstacles --renderer "$1" --set "$solids"; }
obstacles cpu
result $? "obstacles"
golden obstacles-water --renderer cpu --set "$solids" --set render.style=surface --color solid
result $? "obstacles in water"
golden obstacles-clear --renderer cpu --set "$solids" --set render.transparent=true --set render.box=false
result $? "obstacles over nothing"

gate=cross-driver
for renderer in egl osmesa; do
    "$SPH" list renderers | grep "^ *$renderer" | grep -q 'not in this build' && continue
    for name in color-velocity color-solid; do
        golden "$name" --renderer $renderer --color "${name#color-}"
        result $? "$renderer: $name"
    done
    golden outline --renderer $renderer --set render.outline=0.3
    result $? "$renderer: outline"
    golden orthographic --renderer $renderer --set camera.projection=orthographic
    result $? "$renderer: orthographic"
    golden faces --renderer $renderer --set render.box=faces
    result $? "$renderer: faces"
    golden fading --renderer $renderer --set 'render.background_top=[0.2, 0.3, 0.5]'
    result $? "$renderer: fading background"
    obstacles $renderer
    result $? "$renderer: obstacles"
    shadow $renderer
    result $? "$renderer: render.shadow=0.5"
    for style in grid checker; do
        floor $style $renderer
        result $? "$renderer: render.floor=$style"
    done
done
echo "1..$n"
