#!/bin/sh
# On a machine with a GPU (make bench-gpu): steps of dam breaks of 50 thousand to 10 million particles on
# cuda and cpu, of the wcsph and isph solvers, as JSON under out/gpu; then a film.
set -eu
: "${BUILD:=build}" "${OUT:=out/gpu}" "${DEVICE:=cuda}" "${STEPS:=50}"
mkdir -p "$OUT"
SPH=$BUILD/sph-render
$SPH list devices | tee "$OUT/devices.txt"

# bench NAME BACKEND STEPS ARGUMENTS...
bench() {
    name=$1 backend=$2 steps=$3
    shift 3
    echo "$name on $backend"
    $SPH bench "$@" --backend "$backend" --steps "$steps" --json >"$OUT/$name-$backend.json" &&
        jq -r '.scenes[0] | "  \(.particles) particles: \(.ns_per_particle_step) ns per particle and step, \(1 / .ns_per_particle_step) billion per second, \(.bytes_per_particle_step) bytes, \(100 * .bytes_per_second / (.copy_bandwidth + 1e-9) * 10 | round / 10) % of copy bandwidth, \(100 * .peak_share) % of multiply-adds"' \
            "$OUT/$name-$backend.json" || echo "  failed"
}

for support in 2.0 2.6; do
    for size in 50k:0.011754385964912281 1M:0.00433 10M:0.00201; do
        spacing=${size#*:} label=${size%%:*}
        for solver in wcsph isph; do
            scene=scenes/bench/dambreak-50k.json
            [ $solver = wcsph ] || scene=scenes/bench/dambreak-50k-isph.json
            bench "$solver-$label-$support" "$DEVICE" "$STEPS" $scene --set particles.spacing="$spacing" \
                --set solver.support=$support
            [ "$label" != 50k ] || bench "$solver-$label-$support" cpu "$STEPS" $scene \
                --set particles.spacing="$spacing" --set solver.support=$support
        done
    done
    bench "wcsph-phases-$support" "$DEVICE" "$STEPS" scenes/bench/dambreak-50k.json --phases \
        --set particles.spacing=0.00433 --set solver.support=$support
done
for scene in scenes/seeds/s0-c1.json scenes/seeds/s0-c2.json scenes/seeds/s0-c3.json; do
    bench "$(basename "$scene" .json)" "$DEVICE" "$STEPS" "$scene"
    bench "$(basename "$scene" .json)" cpu "$STEPS" "$scene"
done
echo "a film of a million particles, 1920x1080"
$SPH scenes/bench/dambreak-50k.json --set particles.spacing=0.00433 --size 1920x1080 --fps 60 --end 0.5 \
    --backend "$DEVICE" -o "$OUT/film.mp4" --report "$OUT/film.json" 2>&1 | tail -3 | tee "$OUT/film.txt"
echo "error against run time, on processors and the GPU"
$SPH study studies/gpu/*.json -o "$OUT/study" --budget 10m
