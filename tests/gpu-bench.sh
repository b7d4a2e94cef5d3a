#!/bin/sh
# On a machine with a GPU (make bench-gpu): steps of dam breaks by every fast solver, passes, films, and studies of
# processors and GPU. JSON and summary.md under out/gpu. What is said of the names below shortens it.
set -u
: "${BUILD:=build}" "${OUT:=out/gpu}" "${DEVICE:=cuda}" "${STEPS:=50}" "${FRAMES:=60}" "${PICTURE:=1920x1080}"
: "${SIZES:=50k:0.011754385964912281 1M:0.00433 10M:0.00201}" "${MILLION:=0.00433}" \
    "${SUPPORTS:=2.0 2.6}" "${SEEDS=s0-c1 s0-c2 s0-c3}" "${BUDGET:=10m}"
mkdir -p "$OUT"
command -v jq >"$OUT/out" || { echo "jq is not here: install it (apt-get install jq)"; exit 1; }
SPH=$BUILD/sph-render
summary=$OUT/summary.md
say() { echo "$*" | tee -a "$summary"; }
: >"$summary"
"$SPH" list devices | tee "$OUT/devices.txt"
say "Measured $(date +%F) by $("$SPH" --version): $(sed -n "s/^ *\(cuda:[0-9]* .*\)/\1/p" "$OUT/devices.txt" | sed -n "/^$(echo "$DEVICE" | sed 's/^cuda$/cuda:0/') /p")"

# bench NAME BACKEND ARGUMENTS...: leaves OUT/NAME-BACKEND.json
bench() {
    name=$1 backend=$2
    shift 2
    json=$OUT/$name-$backend.json
    "$SPH" bench "$@" --backend "$backend" --steps "$STEPS" --json >"$json" 2>"$OUT/err" && return
    echo "$name on $backend failed: $(tail -n 1 "$OUT/err")"
    rm -f "$json"
    return 1
}
# row NAME BACKEND ARGUMENTS...: a row of the table of steps
row() {
    bench "$@" && jq -r --arg name "$1" --arg on "$2" '.scenes[0] |
        "| \($name) | \($on) | \(.particles) | \(.pairs_per_particle * 10 | round / 10) | \(.ms_per_step) | " +
        "\(.ns_per_particle_step) | \(1 / .ns_per_particle_step * 1000 | round / 1000) | \(.bytes_per_particle_step) | " +
        "\(if .copy_bandwidth > 0 then 1000 * .bytes_per_second / .copy_bandwidth | round / 10 else "" end) | " +
        "\(1000 * .peak_share | round / 10) |"' "$json" | tee -a "$summary"
}

# scene_of SOLVER
scene_of() {
    case $1 in
    wcsph) echo scenes/bench/dambreak-50k.json ;;
    *) echo "scenes/bench/dambreak-50k-isph.json --set solver.method=$1" ;;
    esac
}

say ""
say "| steps | on | particles | pairs a particle | ms a step | ns a particle | 10⁹ particle-steps/s | bytes a particle | % of copying | % of multiply-adds |"
say "|---|---|---|---|---|---|---|---|---|---|"
for support in $SUPPORTS; do
    for size in $SIZES; do
        spacing=${size#*:} label=${size%%:*}
        for solver in wcsph isph dfsph; do
            set -- $(scene_of $solver) --set particles.spacing="$spacing" --set solver.support=$support
            row "$solver-$label-$support" "$DEVICE" "$@"
            [ "$label" != 50k ] || row "$solver-$label-$support" cpu "$@"
        done
    done
done
for seed in $SEEDS; do
    row "$seed" "$DEVICE" "scenes/seeds/$seed.json"
    row "$seed" cpu "scenes/seeds/$seed.json"
done

say ""
say "Passes of a million particles, each timed by itself: ns a particle for one run of it."
say ""
for solver in wcsph isph dfsph; do
    bench "phases-$solver" "$DEVICE" $(scene_of $solver) --phases --set particles.spacing="$MILLION" &&
        say "$(jq -r --arg solver "$solver" '.scenes[0] | .runs_per_step as $runs |
            "- \($solver): " + ([.phases | to_entries[] |
                "\(.key) \(.value / $runs[.key] * 1000 | round / 1000) (\($runs[.key]) a step)"] | join(", "))' "$json")"
done

say ""
say "Films of a million particles, $PICTURE, $FRAMES frames a 600th of a second apart: ms a frame for each thread's work."
say ""
for renderer in egl cuda cpu; do
    for output in "$OUT/film.mp4" hash; do
        "$SPH" scenes/bench/dambreak-50k.json --set particles.spacing="$MILLION" --size "$PICTURE" --fps 600 \
            --end "$(echo "$FRAMES" | awk '{print ($1 - 1) / 600}')" --backend "$DEVICE" --renderer "$renderer" -v \
            -o "$output" --report "$OUT/film-$renderer.json" >"$OUT/out" 2>"$OUT/film-$renderer.txt" || {
            echo "a film by $renderer failed: $(tail -n 1 "$OUT/film-$renderer.txt")"
            continue
        }
        say "- $renderer, $(basename "$output"), $(grep -o 'frames are .*' "$OUT/film-$renderer.txt"): $(jq -r '
            (.frames | length) as $n | .seconds | [["wall", .wall], ["solve", .solve], ["draw", .draw], ["encode", .encode]] |
            map("\(.[0]) \(1e5 * .[1] / $n | round / 100)") | join(", ")' "$OUT/film-$renderer.json")"
    done
done
rm -f "$OUT/err" "$OUT/out"

echo "error against run time on processors and the GPU, and threads of a block"
"$SPH" study studies/gpu/*.json -o "$OUT/study" --budget "$BUDGET" && cat "$OUT/study/summary.md" >>"$summary"
