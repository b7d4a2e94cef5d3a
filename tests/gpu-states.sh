#!/bin/sh
# On a machine with a GPU (make test-gpu): states of cuda have the bits of cpu in every scene, frames can
# be drawn from them, and compute-sanitizer finds nothing. Not run by make test.
. tests/tap.sh
: "${BUILD:=build}" "${DEVICE:=cuda}"
SPH=$BUILD/sph-render
export OMP_WAIT_POLICY=passive

# states BACKEND ARGUMENTS...: "time hash" of each frame
states() {
    backend=$1
    shift
    "$SPH" -q "$@" --backend "$backend" -o null --report "$work/report.json" 2>"$work/err" || return 1
    jq -r '.frames[] | "\(.time) \(.state)"' "$work/report.json"
}

# same NAME SCENE ARGUMENTS...
same() {
    name=$1
    shift
    states cpu "$@" >"$work/cpu" && states "$DEVICE" "$@" >"$work/cuda" &&
        [ -s "$work/cpu" ] && cmp "$work/cpu" "$work/cuda" >>"$work/err" 2>&1
    result $? "$name: $(wc -l <"$work/cpu") states"
    [ ! -s "$work/err" ] || sed 's/^/# /' "$work/err" | head -5
}

# clean TOOL SCENE ARGUMENTS...
clean() {
    tool=$1
    shift
    compute-sanitizer --tool "$tool" --error-exitcode 9 "$SPH" -q "$@" --backend "$DEVICE" -o null \
        >"$work/err" 2>&1
    result $? "compute-sanitizer $tool: $1"
}

"$SPH" list devices | sed 's/^/# /'
for scene in scenes/*.json scenes/seeds/*.json scenes/validation/*.json scenes/stability/*.json; do
    same "$scene" "$scene" --end "$(jq -r '.time.end / 20' "$scene")" --fps "$(jq -r '200 / .time.end' "$scene")"
done
same "dfsph" scenes/dambreak.json --set 'solver={"method": "dfsph"}' --set particles.spacing=0.035 --end 1.2
same "explicit dam break" tests/scenes/dam.json
same "two fluids" tests/scenes/two-fluids.json
same "two fluids, pressure midway" tests/scenes/two-fluids.json --set solver.pressure_form=average
same "wall particles" tests/scenes/wall-particles.json
same "diffusion by gradients" tests/scenes/dam.json --set solver.diffusion_form=antuono
same "periodic" tests/scenes/periodic.json
same "shifting" tests/scenes/taylor-green.json
same "thick" tests/scenes/honey.json
same "thick, Laplacian" tests/scenes/honey.json --set solver.viscosity_form=morris
same "isph, thick" tests/scenes/honey.json --set 'solver={"method": "isph"}'
same "isph, two fluids" tests/scenes/projection-two-fluids.json
same "isph, wall particles" tests/scenes/projection-wall-particles.json
same "isph, enclosed" tests/scenes/projection-vortices.json
same "drop in another fluid" tests/scenes/drop-in-fluid.json --end 0.02 --fps 500
if command -v compute-sanitizer >"$work/out"; then
    for tool in memcheck racecheck initcheck synccheck; do
        clean $tool scenes/dambreak.json --set particles.spacing=0.08 --end 0.02
        clean $tool tests/scenes/wall-particles.json --end 0.01
        clean $tool tests/scenes/honey.json --end 0.01
        clean $tool tests/scenes/projection-two-fluids.json --end 0.01
    done
else
    echo "# compute-sanitizer is not here: memory and races are not checked"
fi
# frames RENDERER ARGUMENTS...: pictures of states on the GPU are those of states on processors; says in $work/how
# whether they were drawn where they are computed
frames() {
    renderer=$1
    shift
    for backend in cpu "$DEVICE"; do
        "$SPH" -v scenes/dambreak.json --end 0.1 --backend "$backend" --renderer "$renderer" "$@" -o hash \
            >"$work/frames-$backend" 2>"$work/err" || return 1
    done
    grep -o 'frames are .*' "$work/err" >"$work/how"
    [ "$(wc -l <"$work/frames-cpu")" -ge 2 ] && cmp "$work/frames-cpu" "$work/frames-$DEVICE"
}
for color in velocity vorticity start.x density-error; do
    frames cpu --color $color
    result $? "frames by $color, cpu renderer: $(cat "$work/how")"
    frames cuda --color $color && grep -q "drawn where" "$work/how"
    result $? "frames by $color, cuda renderer: $(cat "$work/how")"
    if "$SPH" list devices | grep -q "OpenGL by EGL device"; then
        frames egl --color $color
        result $? "frames by $color, egl renderer: $(cat "$work/how")"
    fi
done
"$SPH" -q scenes/dambreak.json --at 0.3 --backend "$DEVICE" --renderer cuda -o "$work/cuda.pfm" &&
    "$SPH" -q scenes/dambreak.json --at 0.3 --backend cpu --renderer cpu -o "$work/cpu.pfm" &&
    cmp "$work/cuda.pfm" "$work/cpu.pfm"
result $? "a raw image, copied to the host"
if [ -x "$BUILD/tests/t442_device" ]; then
    "$BUILD/tests/t442_device" >"$work/err" 2>&1
    result $? "events and buffers of OpenGL: $(grep -c SKIP "$work/err") skipped"
fi
echo "1..$n"
