#!/bin/sh
# Tests sets, films and --reference: missing frames, accepted versions, updates, pages, interruption.
. tests/tap.sh
scene="$work/scene.json"
cat >"$scene" <<'X'
{ "gravity": [0, -9.81, 0], "domain": {"min": [0, 0, 0], "max": [1.6, 1, 0.67]},
  "particles": {"spacing": 0.06}, "fluids": [{"density": 1000, "viscosity": 0.001}],
  "bodies": [{"shape": "box", "min": [0, 0, 0], "max": [0.4, 0.4, 0.67]}],
  "time": {"end": 0.2}, "movie": {"size": [160, 90], "fps": 20}, "color": {"by": "velocity", "range": [0, 3]} }
X
# run WANTED-CODE TEXT NAME ARGUMENTS...: the exit code, and TEXT in what it says
run() {
    code=$1 text=$2 name=$3
    shift 3
    "$SPH" "$@" >"$work/out" 2>&1
    rc=$?
    echo "exit code $rc, wanted $code and: $text" >>"$work/out"
    [ "$rc" = "$code" ] && head -n -1 "$work/out" | grep -qF -e "$text"
    result $? "$name"
}
frames() { (cd "$1" && ls | tr '\n' ' '); }
ref="$work/ref" all="frame-0000.png frame-0001.png frame-0002.png frame-0003.png frame-0004.png "

run 2 "--update" "nothing is accepted yet" "$scene" --reference "$ref"
run 0 "5 frames accepted" "frames are accepted" "$scene" --reference "$ref" --update
[ "$(frames "$ref")" = "$all" ]; result $? "as frame-0000.png and so on, and nothing else is left"
run 0 "5 frames, 5 equal" "the same run is equal" "$scene" --reference "$ref" --gate exact
run 1 "first frame-0000.png" "another radius differs" \
    -q "$scene" --reference "$ref" --set render.radius=0.7 -o "$work/f.mp4" --html "$work/page.html"
[ "$(grep -o 'data:image/png;base64,' "$work/page.html" | wc -l)" = 15 ] && ! grep -q '<script\|src="[^d]' "$work/page.html"
result $? "its page holds three pictures a frame, and needs no other file"
if "$SPH" list encoders | grep -E '^ *mp4' | grep -qv 'not in this build'; then
    [ -s "$work/f.mp4" ]; result $? "its film is kept"
fi
cp -r "$ref" "$work/before"
mkdir "$work/torn" "$work/none" && cp "$ref"/*.png "$work/torn" && echo torn >"$work/torn/frame-0003.png"
run 2 "frame-0003.png" "an accepted frame that cannot be read" \
    -q "$scene" --reference "$work/torn" -o "$work/none/%d.png" --report "$work/none/r.json" --html "$work/none/p.html"
[ -z "$(ls "$work/none")" ]; result $? "ends the run, and nothing is written"
"$SPH" -q "$scene" --reference "$ref" --set render.radius=0.7 >"$work/out" 2>&1
diff -r "$ref" "$work/before" >"$work/out"; result $? "comparing changes nothing"
run 1 "frame-0004.png: missing" "a shorter film lacks a frame" "$scene" --reference "$ref" --end 0.15
run 0 "4 frames accepted" "and can be accepted" "$scene" --reference "$ref" --end 0.15 --update
[ "$(frames "$ref")" = "${all%frame-0004.png }" ]; result $? "without the old frame"
run 1 "frame-0004.png: extra" "then the longer one has an extra frame" "$scene" --reference "$ref"
run 0 "5 equal" "two accepted versions: either will do" "$scene" --reference "$ref" --reference "$work/before"
run 2 "give one" "an update needs one of them" "$scene" --reference "$ref" --reference "$work/before" --update
run 0 "1 frame accepted" "one picture is accepted" "$scene" --at 0.1 --reference "$work/still" --update
[ "$(frames "$work/still")" = "frame.png " ]; result $? "as frame.png"
run 0 "same" "and compared" "$scene" --at 0.1 --reference "$work/still"
run 1 "1 of 1 frame differs" "also when it differs" "$scene" --at 0.15 --reference "$work/still"
run 0 "same" "names as for -o" "$scene" --reference "$work/before/frame-%04d.png"
run 2 "needs --reference" "--update alone" "$scene" -o null --update
run 2 "did you mean exact?" "a gate that is none" "$scene" --reference "$ref" --gate exat
run 4 "cannot make directory" "a place that is not there" "$scene" --reference "$work/no/dir" --update
run 4 "create it first" "a page that cannot be written" "$scene" --reference "$ref" --html "$work/no/p.html"

# Interrupted, an update leaves everything as it was.
cp -r "$ref" "$work/kept"
timeout --foreground -s INT 0.7 "$SPH" "$scene" --reference "$ref" --update --set particles.spacing=0.012 >"$work/out" 2>&1
rc=$?
diff -r "$ref" "$work/kept" >>"$work/out" && [ "$rc" != 0 ]; result $? "an interrupted update changes nothing"

# Sets by the sub-command.
b="$work/before"
mkdir "$work/few" && cp "$b/frame-0001.png" "$b/frame-0003.png" "$work/few"
run 1 "frame-0000.png: missing" "a directory that lacks frames" compare "$work/few" "$b"
run 1 "5 frames, 2 equal, 3 extra" "and one that has too many" compare "$b" "$work/few"
run 0 "2 equal" "a glob pattern" compare "$work/few" "$b/frame-000[13].png"
run 0 "2 equal" "a numbered pattern, from where it starts" compare "$work/few/frame-%04d.png" "$work/few/frame-%04d.png"
run 0 '"same": true' "JSON on standard output" compare "$b" "$b" --json -
jq -e '.frames | length == 5' "$work/out" >/dev/null 2>&1 || head -n -1 "$work/out" | jq -e '.frames | length == 5' >/dev/null
result $? "that holds every frame"
run 1 "" "pictures of what differs" compare "$b" "$work/few" --side-by-side "$work/s-%02d.png" --diff "$work/d-%02d.png"
[ -s "$work/s-00.png" ] && [ ! -e "$work/s-01.png" ] && [ ! -e "$work/d-00.png" ]
result $? "beside each other, for frames that fail"
run 2 "no regular file" "a device is not replaced" compare "$b" "$b" --json /dev/null
(ulimit -f 8; "$SPH" compare "$b" "$work/few" --html "$work/big.html" >"$work/out" 2>&1)
[ $? = 2 ] && grep -q 'too large' "$work/out" && [ -z "$(ls "$work" | grep big)" ]
result $? "a full disk is an error, and leaves nothing"
if "$SPH" list encoders | grep -E '^ *mp4' | grep -qv 'not in this build'; then
    "$SPH" -q "$scene" -o "$work/a.mp4" && "$SPH" -q "$scene" --end 0.15 -o "$work/b.mp4"
    run 0 "5 frames, 5 equal" "a film is equal to itself" compare "$work/a.mp4" "$work/a.mp4" --gate exact
    run 1 "frame 4: extra" "films of other lengths" compare "$work/a.mp4" "$work/b.mp4"
    run 0 "5 frames" "a film and its pictures, but for compression" compare "$work/a.mp4" "$b/frame-%04d.png" \
        --max-fraction 1 --min-psnr 30
    run 2 "neither a PNG picture nor a film" "a file that is neither" compare "$scene" "$scene"
    run 2 "only" "a film and a directory" compare "$work/a.mp4" "$b"
else
    run 2 "make LIBAV=1" "a film without libav" compare "$work/f.mp4" "$work/f.mp4"
fi
echo "1..$n"
