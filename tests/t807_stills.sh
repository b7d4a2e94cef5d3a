#!/bin/sh
# Tests pictures of single times: --at lists, contact sheets, the printed camera, films through pipes.
. tests/tap.sh
cat >"$work/scene.json" <<'X'
{ "domain": {"min": [0, 0, 0], "max": [0.5, 0.5, 0.5]}, "particles": {"spacing": 0.0625},
  "fluids": [{}], "bodies": [{"shape": "box", "min": [0, 0, 0], "max": [0.25, 0.25, 0.5]}],
  "camera": {"orbit_period": 2}, "time": {"end": 0.4}, "movie": {"size": [64, 48], "fps": 100} }
X
# shoot ARGUMENTS...: what is printed goes to $work/text
shoot() {
    "$SPH" -q "$work/scene.json" --threads 1 "$@" >"$work/text" 2>"$work/out"
}
# png_size FILE: "WIDTH HEIGHT" from the header
png_size() {
    od -An -tu1 -j16 -N8 "$1" | awk '{print 16777216*$1+65536*$2+256*$3+$4, 16777216*$5+65536*$6+256*$7+$8}'
}

shoot --at 0.3,0.1 --at 0 --set 'measure=[{"quantity": "speed"}]' -o hash -o "$work/fig-%03d.png" \
    -o "$work/fig.csv"
result $? "--at lists times"
[ "$(cut -d' ' -f1,2 "$work/text" | tr '\n' ';')" = "0 0;1 0.1;2 0.3;" ]
result $? "frames are at exactly these times, in order"
[ "$(ls "$work"/fig-*.png | tr '\n' ' ')" = "$work/fig-000.png $work/fig-001.png $work/fig-002.png " ]
result $? "each has its picture"
[ "$(tail -n +2 "$work/fig.csv" | cut -d, -f1 | tr '\n' ' ')" = "0 0.1 0.3 " ]
result $? "and its row"

shoot --sheet 3x2 -o "$work/sheet.png" -o hash && cp "$work/text" "$work/sheet.txt"
result $? "a sheet is one picture"
[ "$(cut -d' ' -f1,2 "$work/sheet.txt")" = "0 0.4" ]
result $? "of times up to the end"
# Text of 8 pixels: gaps of 8, bands of 21.
[ "$(png_size "$work/sheet.png")" = "$((8 + 3 * (64 + 8))) $((8 + 2 * (48 + 21)))" ]
result $? "as large as its frames, labels and gaps: $(png_size "$work/sheet.png")"
shoot --sheet 3x2 --at 0,0.08,0.16,0.24,0.32,0.4 -o hash && cmp "$work/text" "$work/sheet.txt" >>"$work/out"
result $? "by default they are equally far apart"
shoot --sheet 2x2 --at 0.1,0.2,0.3 -o hash && ! cmp -s "$work/text" "$work/sheet.txt"
result $? "fewer times leave a cell empty"

# The printed camera is the same again, to eight digits.
eight() { sed -E 's/(\.[0-9]{8})[0-9]*/\1/g' "$1"; }
same_camera() {
    eight "$work/a.txt" >"$work/a8" && eight "$work/b.txt" | cmp "$work/a8" - >>"$work/out"
}
camera() { # ARGUMENTS of the second scene's print
    { sed 's/"camera": {[^}]*},//; $d' "$work/scene.json"
      printf '  "time": {"end": 0.4}, "movie": {"size": [64, 48], "fps": 100},\n'; cat; echo "}"; } >"$work/b.json"
    "$SPH" "$work/b.json" --print-camera "$@" >"$work/b.txt" 2>>"$work/out"
}
shoot --print-camera --at 0.3 && cp "$work/text" "$work/a.txt"
camera --at 0.3 <"$work/a.txt" && same_camera
result $? "the printed camera prints the same again"
shoot --print-camera --at 0,0.1,0.4 && cp "$work/text" "$work/a.txt"
camera --at 0,0.1,0.4 <"$work/a.txt" && same_camera
result $? "and so do keyframes"

# noted KEY=VALUE OUTPUT...: how many warnings there are that the key has no effect
noted() {
    key=$1
    shift
    "$SPH" "$work/scene.json" --threads 1 --at 0 --set "$key" "$@" 2>&1 | tee "$work/out" |
        grep -c "warning: ${key%=*} has no effect: it is for"
}
[ "$(noted movie.crf=20 -o "$work/n.png")$(noted movie.pixel_format=yuv444p -o "$work/n.png")" = 11 ]
result $? "a key of compression that no output heeds is said"
[ "$(noted movie.crf=20 -o null)" = 0 ]
result $? "but not where nothing is drawn"
if "$SPH" list encoders | grep -q '^ *y4m.*not in this build'; then
    echo "1..$n"
    exit
fi
"$SPH" "$work/scene.json" --threads 1 --at 0,0.1 -o - >"$work/film.y4m" 2>"$work/out"
[ $? = 0 ] && [ "$(wc -c <"$work/film.y4m")" = $(($(head -n 1 "$work/film.y4m" | wc -c) + 2 * (6 + 64 * 48 * 3 / 2))) ]
result $? "a film on standard output is alone there"
[ "$(head -c 22 "$work/film.y4m")" = "YUV4MPEG2 W64 H48 F100" ]
result $? "and begins with its size"
[ "$(noted movie.preset=veryfast -o "$work/n.gif")$(noted movie.crf=20 -o "$work/n.mp4" -o "$work/n.png")" = 10 ]
result $? "films that heed a key do not say so"
"$SPH" -q "$work/scene.json" --threads 1 --at 0 -o - 2>"$work/out" >/dev/full
[ $? = 4 ]
result $? "a full standard output is exit code 4"
shoot --at 0 -o "$work/none.mp4" --set movie.codec=h264 --set movie.options=nonsense=1
[ $? = 2 ] && grep -q "movie.options: nonsense: codec h264 has no such option; it has" "$work/out" &&
    [ -z "$(ls "$work" | grep none)" ]
result $? "a wrong option is exit code 2, and nothing is written"
"$SPH" "$work/scene.json" -v --threads 1 --at 0 -o "$work/v.mp4" >"$work/out" 2>&1
[ "$(grep -c "video codec .*; passed over, since .*: h264-nvenc, hevc-nvenc" "$work/out")" = 1 ]
result $? "-v says once that a GPU's codec is not chosen, and why"
echo before >"$work/gpu.mp4"
"$SPH" "$work/scene.json" --threads 1 --at 0 --size 160x96 -o "$work/gpu.mp4" --set movie.codec=h264-nvenc \
    >"$work/out" 2>&1
code=$?
[ $code = 0 ] || { [ $code = 3 ] && grep -q 'h264-nvenc cannot be opened: .*; use "h264"' "$work/out" &&
    ! grep -q " particles," "$work/out" && [ "$(cat "$work"/gpu.mp4*)" = before ]; }
result $? "a GPU's codec without one is exit code 3 before anything is computed; the earlier film stays"
echo "1..$n"
