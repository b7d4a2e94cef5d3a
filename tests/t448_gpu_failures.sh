#!/bin/sh
# Tests what the whole program does when a GPU is lost in the middle of a run, or has too little memory: a model of a
# GPU fails when it is told to. Exit code 1 with the kernel's name, what was drawn is kept, earlier files are intact.
. tests/tap.sh
: "${BUILD:=build}"
model=$BUILD/model/sph-render
if [ ! -x "$model" ] || "$model" list encoders | grep -q '^ *gif .*not in this build'; then
    echo "ok 1 - # SKIP this build has no CUDA, or no films"
    echo "1..1"
    exit 0
fi
mkdir "$work/film"
# film ARGUMENTS...: 4 frames, rows and a report
film() {
    rm -f "$work"/film/*
    echo earlier >"$work/film/m.gif"
    "$model" -q scenes/dambreak.json --set particles.spacing=0.1 --end 0.1 --size 80x45 --backend cuda "$@" \
        -o "$work/film/f-%d.png" -o "$work/film/x.csv" -o "$work/film/m.gif" --report "$work/film/r.json" 2>"$work/out"
}
frames() { find "$work/film" -name 'f-*' | wc -l; }
left() { find "$work/film" -name '*.part' -o -name '*.lock'; }

film --renderer cuda
[ $? = 0 ] && [ "$(frames)" = 4 ] && [ "$(wc -l <"$work/film/x.csv")" = 5 ]
result $? "nothing fails: 4 frames, 4 rows"
all=0 most=0 named=0
for renderer in cuda cpu; do
    for kernel in 1 2 30 100 200 400 600 800 900; do
        export GPU_MODEL_LOST=$kernel
        film --renderer $renderer
        rc=$? drawn=$(frames)
        unset GPU_MODEL_LOST
        most=$((drawn > most ? drawn : most))
        named=$((named + $(grep -c 'the GPU failed in or before [a-z].*: unspecified launch failure' "$work/out")))
        [ "$(head -c 7 "$work/film/m.gif")" = earlier ] && old=yes || old=no
        echo "exit code $rc, $drawn frames, earlier film $old, $(left)" >>"$work/out"
        # what is kept of the three outputs: each that was fed
        [ $rc = 1 ] && [ -z "$(left)" ] && [ "$drawn" -lt 4 ] && case $drawn in 0) [ $old = yes ] ;; *) [ $old = no ] ;; esac
        result $? "$renderer, lost with kernel $kernel: $drawn frames"
        all=$((all + 1))
    done
done
[ $most -ge 1 ] && [ $named = $all ]
result $? "frames are kept, at most $most; $named of $all errors name a kernel"
# Rows come before any picture.
GPU_MODEL_LOST=600 film --renderer cuda --set movie.start=0.09 --set time.measure=0.01
[ $? = 1 ] && [ "$(frames)" = 0 ] && [ "$(wc -l <"$work/film/x.csv")" -ge 2 ] && [ "$(cat "$work/film/m.gif")" = earlier ]
result $? "rows are kept without a picture: $(wc -l <"$work/film/x.csv") lines"

# refused CODE TEXT: nothing is written
refused() {
    [ $? = "$1" ] && grep -q "$2" "$work/out" && [ "$(ls "$work/film")" = m.gif ] && [ "$(cat "$work/film/m.gif")" = earlier ]
    result $? "exit code $1: $2"
}
GPU_MODEL_MEMORY=50000 film --renderer cuda
refused 1 "makes about 112 particles, which take .* of a model of a GPU, but .* are free there: use a spacing of"
GPU_MODEL_MEMORY=1000000 GPU_MODEL_SHORT=940000 film --renderer cpu
refused 1 "take .* GB of the GPU's memory, of which .* GB are free (out of memory): use a larger particles.spacing"
GPU_MODEL_MEMORY=1000000 GPU_MODEL_SHORT=1000000 film --renderer cuda
refused 1 "take .* GB of the GPU's memory"
# A driver that is older than the program's CUDA: auto takes the processors, and says why.
GPU_MODEL_DRIVER=12040 "$model" scenes/dambreak.json --set particles.spacing=0.1 --end 0.01 -o null 2>"$work/out" &&
    grep -q 'warning: the GPU.s driver knows CUDA up to 12.4, and this program was built with 13.0' "$work/out"
result $? "a driver that is too old is said, and auto takes the processors"
GPU_MODEL_DRIVER=12040 film --renderer cuda
refused 3 "driver knows CUDA up to 12.4"
echo "1..$n"
