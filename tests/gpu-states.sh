#!/bin/sh
# On a machine with a GPU (make test-gpu): states of cuda have the bits of cpu in every scene, frames can
# be drawn from them, and compute-sanitizer finds nothing. SCENES and SHORT (s, the end of every run) shorten it.
. tests/tap.sh
: "${BUILD:=build}" "${DEVICE:=cuda}" "${SHORT:=}"
: "${SCENES:=scenes/*.json scenes/seeds/*.json scenes/validation/*.json scenes/stability/*.json}"
SPH=$BUILD/sph-render
export OMP_WAIT_POLICY=passive
command -v jq >"$work/out" || { echo "not ok 1 - jq is not here: install it (apt-get install jq)"; exit 1; }

# states BACKEND ARGUMENTS...: "time hash" of each frame
states() {
    backend=$1
    shift
    case "$SHORT $*" in
    " "* | *" --at "*) ;;
    *) set -- "$@" --end "$SHORT" --fps 1000 ;;
    esac
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
    [ -z "$SHORT" ] || set -- "$@" --end "$SHORT"
    compute-sanitizer --tool "$tool" --error-exitcode 9 "$SPH" -q "$@" --backend "$DEVICE" --size 160x90 -o hash \
        >"$work/err" 2>&1
    found=$?
    # CUB's sorting and scanning have reports of their own (NVIDIA/cccl issues 1892, 1902, 1906)
    if [ "$tool" = racecheck ] && [ $found = 9 ] && grep -q 'reported between' "$work/err" &&
        ! grep -A1 'reported between' "$work/err" | grep -qv -e 'cub::' -e '^--'; then
        found=0
        set -- "$1, but for what is within CUB"
    fi
    result $found "compute-sanitizer $tool: $1"
    [ $found = 0 ] || sed 's/^/# /' "$work/err" | head -20
}

"$SPH" list devices | sed 's/^/# /'
for scene in $SCENES; do
    times=$(jq -r --arg short "$SHORT" '(if $short == "" then .time.end / 20 else $short | tonumber end) as $last |
        [range(11) * $last / 10 | tostring] | join(",")' "$scene")
    same "$scene" "$scene" --at "$times"
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
whole=$DEVICE
for block in 32 512; do
    case $whole in
    *:*) DEVICE=$whole:$block ;;
    *) DEVICE=$whole:0:$block ;;
    esac
    same "$block threads a block" tests/scenes/dam.json
done
DEVICE=$whole
same "drop in another fluid" tests/scenes/drop-in-fluid.json --end 0.02 --fps 500
if command -v compute-sanitizer >"$work/out"; then
    for tool in memcheck racecheck initcheck synccheck; do
        clean $tool scenes/dambreak.json --set particles.spacing=0.08 --end 0.02 --renderer cuda
        clean $tool scenes/dambreak.json --set particles.spacing=0.08 --end 0.02 --renderer cpu
        clean $tool tests/scenes/wall-particles.json --end 0.01 --renderer cuda
        clean $tool tests/scenes/honey.json --end 0.01 --renderer cuda
        clean $tool tests/scenes/projection-two-fluids.json --end 0.01 --renderer cuda
    done
else
    echo "# compute-sanitizer is not here: memory and races are not checked"
fi
# frames RENDERER ARGUMENTS...: pictures of states on the GPU are those of states on processors; says in $work/how
# whether they were drawn where they are computed
frames() {
    renderer=$1
    shift
    [ -z "$SHORT" ] || set -- "$@" --set particles.spacing=0.1 --fps 1000 --size 160x90
    for backend in cpu "$DEVICE"; do
        "$SPH" -v scenes/dambreak.json --end "${SHORT:-0.1}" --backend "$backend" --renderer "$renderer" "$@" -o hash \
            >"$work/frames-$backend" 2>"$work/err" || return 1
    done
    grep -o 'frames are .*' "$work/err" >"$work/how"
    [ "$(wc -l <"$work/frames-cpu")" -ge 2 ] && cmp "$work/frames-cpu" "$work/frames-$DEVICE"
}
# looks NAME ARGUMENTS...: by every renderer; where OpenGL is the GPU's, without a copy as well
looks() {
    name=$1
    shift
    frames cpu "$@"
    result $? "$name, cpu renderer: $(cat "$work/how")"
    frames cuda "$@" && grep -q "drawn where" "$work/how"
    result $? "$name, cuda renderer: $(cat "$work/how")"
    "$SPH" list devices | grep -q "OpenGL by EGL device" || return 0
    frames egl "$@" && grep -q "drawn where" "$work/how"
    result $? "$name, egl renderer: $(cat "$work/how")"
}
looks "speed" --color velocity
looks "vorticity" --color vorticity
looks "where they began" --color start.x --set color.range=auto
looks "density's error" --color density-error --set color.range=auto
looks "pressure, a log scale in steps" --color pressure --set color.scale=log --set color.steps=5 \
    --set 'color.range=[1, 3000]'
looks "walls, in the fluid's colour" --color solid --set render.boundary=true --set domain.walls.-y=particles
looks "cut, and some values" --set 'render.clip_max=[1.2, 1, 0.4]' --set 'render.show_range=[0.02, 9]'
# raw BACKEND RENDERER
raw() {
    "$SPH" -q scenes/dambreak.json --at "${SHORT:-0.3}" --backend "$1" --renderer "$2" -o "$work/$2.depth.pfm"
}
raw "$DEVICE" cuda && raw cpu cpu && cmp "$work/cuda.depth.pfm" "$work/cpu.depth.pfm"
result $? "a raw image, copied to the host"
if [ -x "$BUILD/tests/t442_device" ]; then
    "$BUILD/tests/t442_device" >"$work/err" 2>&1
    result $? "events and buffers of OpenGL: $(grep -c SKIP "$work/err") skipped"
fi
echo "1..$n"
