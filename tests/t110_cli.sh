#!/bin/sh
# Tests the command line: exit codes, messages, lists, and that nothing is written on error.
. tests/tap.sh
scene=scenes/dambreak.json

# run WANTED-CODE TEXT ARGUMENTS...: the exit code, and TEXT in what it says (literally)
run() {
    code=$1 text=$2
    shift 2
    "$SPH" "$@" >"$work/out" 2>&1
    rc=$?
    echo "exit code $rc, wanted $code and: $text" >>"$work/out"
    [ "$rc" = "$code" ] && head -n -1 "$work/out" | grep -qF -e "$text"
    result $? "sph-render $*"
}

run 0 "Usage: sph-render" --help
run 0 "--write-scene" --help
run 0 "sph-render list" --help
run 0 "Exit codes" --help
run 0 "sph-render " --version
run 2 "no scene" 
run 2 "did you mean the sub-command" lst
run 2 "unknown option --colour; did you mean --color?" --colour solid $scene
run 2 "unknown option --zzz" $scene --zzz
run 2 "no output; add -o film.mp4" $scene
run 2 "one scene at a time" $scene $scene --check
run 2 "WIDTHxHEIGHT" $scene --check --size 1280
run 2 "from 16 to 16384" $scene --check --size 4x4
run 2 "--fps fast" $scene --check --fps fast
run 2 "--end -1" $scene --check --end -1
run 2 "--at soon" $scene -o null --at soon
run 2 "add --end 99" $scene -o null --at 99
run 2 "--at 1,soon: give a time" $scene -o null --at 1,soon
run 2 "--at 1,: give a time" $scene -o null --at 1,
run 2 "--at: the time 0.5 is given twice" $scene -o null --at 0.5,1 --at .5
run 2 "add --end 9" $scene -o null --at 1,9,2
run 2 "--sheet 3: write COLUMNSxROWS" $scene -o null --sheet 3
run 2 "--sheet 0x2: write COLUMNSxROWS" $scene -o null --sheet 0x2
run 2 "has room for 2 pictures, and --at gives 3 times" $scene -o null --sheet 2x1 --at 0,1,2
run 2 "did you mean \"camera.fov\"" $scene --check --camera "fvo=20"
run 2 "--camera eye=3,1: camera.eye must be an array of 3 numbers" $scene --check --camera "eye=3,1"
run 2 "write for example \"eye=3,1,3 fov=40\"" $scene --check --camera "eye"
run 0 '"eye": [3, 1, 3], "target"' $scene --print-camera --camera "eye=3,1,3 target=.8,.3,.3 fov=20"
run 0 '"fov": 20}' $scene --print-camera --camera "eye=3,1,3 target=.8,.3,.3 fov=20"
run 2 "-o - and -o hash both write to standard output" $scene -o - -o hash
run 2 "-o - and --write-scene - both write" $scene -o - --write-scene -
run 2 'did you mean "vp9"' $scene --check --set movie.codec=vp8
run 0 "libx265" list codecs
run 2 "--threads -2" $scene --check --threads -2
run 2 "--threads 1.5" $scene --check --threads 1.5
run 2 "is given twice" $scene -o null -o null
run 2 "the name is empty" $scene -o ""
run 2 "did you mean \"wcsph\"" $scene --check --solver wscph
run 2 "--set particles.spacing=1e-5" $scene --check --set particles.spacing=1e-5
run 2 "4294967294 can be numbered" $scene --check --set particles.spacing=1e-5
run 2 "did you mean \"time.end\"" $scene --check --set time.ned=2
run 2 "this is a directory" scenes --check
run 2 "No such file" "$work/none.json" --check
run 0 "$scene: ok" $scene --check
run 0 "ok" $scene --check --size 640x360 --fps 24 --end 1 --solver muller --color solid --threads 2
run 0 '"end": 0.5' $scene --write-scene - --end 0.5
run 0 '"viscosity": 0.25' $scene --write-scene - --set fluids.0.viscosity=0.25
run 4 "create it first" $scene --write-scene "$work/no/such/place.json"
cp $scene "$work/in"
ln "$work/in" "$work/link"
run 2 "it is the scene, too" "$work/in" -o null --report "$work/in"
run 2 "it is the scene, too" "$work/in" -o null --report "$work/./link"
run 2 "it is the scene, too" "$work/in" -o null --reference "$work" --html "$work/in"
run 2 "it is --report, too" $scene -o "$work/x.png" --at 0 --report "$work/./x.png"
run 2 "it is --report, too" $scene -o null --write-scene "$work/x.json" --report "$work/x.json"
run 2 "it is --html, too" $scene -o "$work/x.gif" --html "$work/x.gif" --reference "$work"
run 2 "no encoder writes" $scene -o "$work/x.xyz" --write-scene "$work/x.json"
run 2 "no-such" $scene -o null --write-scene "$work/x.json" --reference "$work/no-such"
run 4 "no regular file" $scene -o null --write-scene "$work"
rm "$work/in" "$work/link"
for full in "--help" "--version" "compare --help" "list keys"; do
    "$SPH" $full >/dev/full 2>"$work/out"
    [ $? = 4 ] && grep -q "standard output cannot be written" "$work/out"
    result $? "a full disk under $full"
done
run 0 "solver.method" list keys
run 0 "additionalProperties" list keys --json-schema
run 0 "wcsph" list solvers
run 0 "sub-commands" list commands
run 0 "flip-p99" list metrics
run 0 "cross-driver" list gates
run 2 "did you mean exact?" compare scenes scenes --gate exat
run 2 "there are no PNG pictures" compare scenes scenes
run 0 "--min-ssim-tile" compare --help
run 0 "bodies[].shape" list
run 2 "did you mean solvers" list solver
run 2 "is of keys" list solvers --json-schema
run 0 "Usage: sph-render list" list --help
run 2 "--threads 2x: give a whole number" bench $scene --threads 2x
run 2 "--from soon: give a time" bench $scene --from soon
run 2 "--isa avx is unknown" bench $scene --isa avx
run 2 "--steps 0: give a whole number" bench $scene --steps 0
run 0 "pairs per second" bench tests/scenes/dam.json --steps 1 --set solver.density=summation
"$SPH" bench $scene --steps 1 --json --set 'title="say \"on\""' 2>"$work/out" |
    jq -e ".scenes[0].runs_per_step.force == 1 or .scenes[0].runs_per_step.product >= 1" >>"$work/out" 2>&1
result $? "bench --json quotes titles, counts runs"

# A message begins with the place: FILE:LINE:COLUMN.
bad() { # NAME LINE:COLUMN TEXT; the file is on stdin
    cat >"$work/bad.json"
    run 2 "$work/bad.json:$2: $3" "$work/bad.json" -o "$work/film.mp4"
}
bad empty 1:1 "the text is empty" </dev/null
bad comma 3:1 "found '}' where a value" <<'X'
{
  "title":
}
X
bad key 2:3 'unknown key "titel"; did you mean "title"?' <<'X'
{
  "titel": "Dam break"
}
X
bad type 2:39 'domain.max must be an array of 3 numbers, not 1' <<'X'
{
  "domain": {"min": [0, 0, 0], "max": 1}
}
X
# bad_camera LINE:COLUMN TEXT KEYS: the dam break with that camera, from line 2 on
bad_camera() {
    jq -c 'del(.camera)' $scene | sed "s|^{|{ \"camera\": {\n$3},\n|" >"$work/in"
    bad camera "$1" "$2" <"$work/in"
}
bad_camera 2:54 "camera.eye and camera.keyframes" '"keyframes": [{"time": 0, "eye": [3, 1, 3]}], "eye": [1, 2, 3]'
bad_camera 3:10 "camera.keyframes.1.time 1 s is not after the 2 s" \
    '"keyframes": [{"time": 2, "eye": [3, 1, 3]},\n{"time": 1, "eye": [3, 1, 3]}]'
bad_camera 2:34 "camera.keyframes.0.eye is its target" \
    '"keyframes": [{"time": 2, "eye": [3, 1, 3], "target": [3, 1, 3]}]'
bad_camera 2:15 '"camera.keyframes.0.eye" is missing' '"keyframes": [{"time": 2}]'
bad_camera 2:16 'unknown key "camera.keyframes.0.tme"; did you mean "camera.keyframes.0.time"' \
    '"keyframes": [{"tme": 2}]'
run 3 "renderer egl" $scene -o "$work/film.mp4" --set render.style=surface --renderer egl
printf '\357\273\277{}' >"$work/in"
bad bom 1:1 "the file begins with a byte order mark" <"$work/in"
printf '{"title": "\0"}' >"$work/in"
bad zero 1:12 "control character" <"$work/in"
head -c 20000000 /dev/zero | tr '\0' ' ' >"$work/huge.json"
run 2 "more than 16 MiB" "$work/huge.json" --check
left=$(ls "$work" | grep -cv -e out -e bad.json -e huge.json -e '^in$')
[ "$left" = 0 ]; result $? "errors leave no file behind"

# The effective scene loads to itself, for every shipped scene.
for s in scenes/*.json scenes/*/*.json; do
    "$SPH" "$s" --write-scene "$work/a.json" >"$work/out" 2>&1 &&
        "$SPH" "$work/a.json" --write-scene "$work/b.json" >>"$work/out" 2>&1 &&
        cmp "$work/a.json" "$work/b.json" >>"$work/out" 2>&1
    result $? "$s round-trips"
done
echo "1..$n"
