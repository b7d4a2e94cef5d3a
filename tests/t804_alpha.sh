#!/bin/sh
# Tests films with alpha: without loss they have the pixels of pictures, and others say that they have none.
. tests/tap.sh
if "$SPH" list encoders | grep -q '^ *mkv .*not in this build'; then
    echo "ok 1 - # SKIP no films in this build"
    echo "1..1"
    exit 0
fi
# draw OUTPUT ARGUMENTS...
draw() {
    out=$1
    shift
    "$SPH" scenes/dambreak.json --set particles.spacing=0.1 --size 160x90 --end 0.01 --set render.transparent=true \
        --renderer cpu "$@" -o "$work/$out" >"$work/out" 2>&1
}
# pixels FILE [DECODER]: the first frame, decoded
pixels() {
    ffmpeg -v error ${2:+-c:v $2} -i "$work/$1" -frames:v 1 -f rawvideo -pix_fmt rgba "$work/$1.raw" 2>>"$work/out"
}
draw a.mkv --set movie.codec=ffv1 --set movie.pixel_format=bgra && ! grep -q warning "$work/out" &&
    draw b-%d.png && pixels a.mkv && pixels b-0.png && cmp "$work/a.mkv.raw" "$work/b-0.png.raw" >>"$work/out"
result $? "ffv1, bgra: the pixels and alpha of a PNG"
draw c.webm --set movie.pixel_format=yuva420p && ! grep -q warning "$work/out" && pixels c.webm libvpx-vp9 &&
    [ "$(od -An -v -tu1 -w4 "$work/c.webm.raw" | awk '$4 == 0' | wc -l)" -gt 5000 ] &&
    [ "$(od -An -v -tu1 -w4 "$work/c.webm.raw" | awk '$4 == 255' | wc -l)" -gt 200 ]
result $? "webm, yuva420p: nothing where there is nothing"
draw d.mp4 && grep -q "warning: the film has no alpha" "$work/out"
result $? "mp4: a warning"
echo "1..$n"
