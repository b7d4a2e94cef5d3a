#!/bin/sh
# Tests csv outputs from outside: rows at the chosen times, the same bytes on every machine, errors
# of scenes, what becomes of earlier files and of runs that end early, nothing paid without one.
. tests/tap.sh
export OMP_WAIT_POLICY=passive
scene=$work/scene.json csv=$work/m.csv
cat >"$scene" <<'X'
{ "domain": {"min": [0, 0, 0], "max": [0.5, 0.5, 0.3]}, "particles": {"spacing": 0.05},
  "fluids": [{"name": "water", "density": 1000, "viscosity": 0.1}],
  "bodies": [{"shape": "box", "min": [0, 0, 0], "max": [0.25, 0.3, 0.3], "jitter": 0.1}],
  "time": {"end": 0.3, "measure": 0.07}, "movie": {"size": [64, 64], "fps": 20},
  "measure": [
    {"quantity": "energy"}, {"quantity": "momentum"}, {"quantity": "mass-centre"},
    {"quantity": "volume"}, {"quantity": "speed"}, {"quantity": "density-error"},
    {"quantity": "pressure", "name": "P1", "at": [0.1, 0.1, 0.1]},
    {"quantity": "wall-pressure", "face": "+x", "min": [0, 0, 0], "max": [0.5, 0.1, 0.3]},
    {"quantity": "front"}, {"quantity": "height", "at": [0.1, 0, 0.1]}, {"quantity": "extent"},
    {"quantity": "profile", "from": [0.1, 0, 0.1], "to": [0.1, 0.3, 0.1], "points": 4},
    {"quantity": "angular-momentum"}, {"quantity": "spread"}, {"quantity": "wave", "wavelength": 0.5},
    {"quantity": "layers", "points": 4}, {"quantity": "flow-error", "flow": "rotation"}] }
X
run() { # ARGUMENTS...
    rm -f "$csv"
    "$SPH" "$scene" --threads 1 "$@" >"$work/out" 2>&1
}
row_times() { tail -n +2 "$csv" | cut -d, -f1 | tr '\n' ' '; }

run -o "$csv"
result $? "a run with a csv output"
[ "$(row_times)" = "0 0.07 0.14 0.21 0.28 " ]
result $? "a row at each chosen time: $(row_times)"
head -n 1 "$csv" | grep -q '^time (s),energy.kinetic (J),energy.potential (J),energy.total (J),mom'
result $? "the first line has names and units"
awk -F, 'NR == 1 {n = NF} NF != n {bad = 1} END {exit bad || n != 80}' "$csv"
result $? "every row has every column"
tail -n +2 "$csv" >"$work/rows"
! grep -qE 'nan|inf|(^|,)-0(,|$)' "$work/rows"
result $? "every value is finite"
cp "$csv" "$work/first.csv"

for threads in 2 3; do
    run --threads $threads -o "$csv"
    cmp "$work/first.csv" "$csv" >>"$work/out" 2>&1
    result $? "the same bytes on $threads threads"
done
for isa in $("$SPH" list isas | awk '{print $1}' | grep -E '^(scalar|avx2|avx512)$'); do
    if [ "$isa" != scalar ] && ! grep -qwE "$isa|${isa}f" /proc/cpuinfo; then
        echo "# $isa: this processor does not have it"
        continue
    fi
    run --isa "$isa" -o "$csv"
    cmp "$work/first.csv" "$csv" >>"$work/out" 2>&1
    result $? "the same bytes with --isa $isa"
done
run --set neighbours=all-pairs -o "$csv"
cmp "$work/first.csv" "$csv" >>"$work/out" 2>&1
result $? "the same bytes with all-pairs"

for other in gcc clang; do # built by t501_same_bits
    [ -x "${BUILD:-build}/$other/sph-render" ] || continue
    "${BUILD:-build}/$other/sph-render" -q "$scene" --threads 2 -o "$csv" >"$work/out" 2>&1
    cmp "$work/first.csv" "$csv" >>"$work/out" 2>&1
    result $? "the same bytes from $other"
done

run --set time.measure=auto -o "$csv"
[ "$(row_times)" = "0 0.05 0.1 0.15 0.2 0.25 0.3 " ]
result $? "by default a row at each frame: $(row_times)"
run --at 0.123 -o "$csv"
[ "$(row_times)" = "0.123 " ]
result $? "--at: one row, at exactly that time"
run --set movie.start=0.2 -o "$csv"
[ "$(row_times)" = "0 0.07 0.14 0.21 0.28 " ]
result $? "rows begin at 0, whenever the film does"

# Frames and rows stop the run at their own times; rows at frame times change no step.
state() { jq -r '.frames[] | "\(.time) \(.state)"' "$work/report.json"; }
run -o null --report "$work/report.json"
state >"$work/plain"
run -o "$csv" --set time.measure=auto --report "$work/report.json"
state | cmp - "$work/plain" >>"$work/out" 2>&1
result $? "rows at frame times change no state"
jq -e '.measured == {"rows": 7, "columns": 80, "every": 0.05} and (.seconds | has("measure"))' \
    "$work/report.json" >"$work/out"
result $? "the report has rows and columns"
run -o "$csv" --report "$work/report.json"
[ "$(state | cut -d' ' -f1)" = "$(cut -d' ' -f1 "$work/plain")" ]
result $? "other rows leave frames at their times"

# within NAME COLUMN WANTED PARTS: of the last row
within() {
    awk -F, -v column="$2" -v wanted="$3" -v parts="$4" 'NR == 1 {
            for (i = 1; i <= NF; i++) if ($i == column) c = i
        } {got = $c} END {
            printf "%s %.5g, wanted %.5g: %+.2f %%\n", column, got, wanted, 100 * (got / wanted - 1)
            exit !(got > wanted * (1 - parts) && got < wanted * (1 + parts))
        }' "$csv" >"$work/out"
    result $? "$1: $(cat "$work/out")"
}
# A tank 12 spacings deep that has come to rest: rho g H, and the volume that was filled.
"$SPH" -q scenes/settling-tank.json -o "$csv" --set particles.spacing=0.025 --end 2 --set 'measure=[
    {"quantity": "wall-pressure", "face": "-y", "min": [0.1, 0, 0.1], "max": [0.4, 0, 0.4]},
    {"quantity": "pressure", "at": [0.25, 0.1, 0.25]}, {"quantity": "volume"},
    {"quantity": "height", "at": [0.25, 0, 0.25]}]' --set fluids.0.viscosity=20 >"$work/out" 2>&1
within "at the floor" "wall-pressure (Pa)" 2648.7 0.03
within "in the fluid" "pressure (Pa)" 1765.8 0.05
within "volume" "volume.surface (m^3)" 0.075 0.01
within "height" "height (m)" 0.3 0.02

# Without a csv output nothing is paid, and a list that is not used is said.
run -o null --report "$work/report.json"
grep -q "measures are not written" "$work/out"
result $? "a list without a csv output gives a notice"
jq -e '(has("measured") or (.seconds | has("measure")) or (.bytes | has("measures"))) | not' \
    "$work/report.json" >"$work/out"
result $? "and takes neither memory nor time"
run -o null --plan && grep -q "measures of the scene: no output is a csv" "$work/out" &&
    ! grep -q "^measured" "$work/out"
result $? "and the plan leaves it out"
run -o "$csv" --plan && grep -q "^measured every 0.07 s, 80 columns" "$work/out" &&
    grep -q "P1, pressure: " "$work/out" && [ ! -e "$csv" ]
result $? "the plan lists what is measured"
run -o "$csv" --set 'measure=[]' && head -n 1 "$csv" | tr ',' '\n' | sed 's/[. ].*//' | uniq |
    tr '\n' ' ' >"$work/out"
[ "$(cat "$work/out")" = "time energy momentum mass-centre speed density-error " ]
result $? "a scene without a list has the usual: $(cat "$work/out")"

# wrong TEXT ARGUMENTS...
wrong() {
    text=$1
    shift
    run --check "$@"
    [ $? = 2 ] && grep -qF -e "$text" "$work/out"
    result $? "$* is refused: $text"
}
wrong 'did you mean "energy"' --set measure.0.quantity=enrgy
wrong 'known: -x, +x' --set measure.7.face=left
wrong 'from 1 to 1000' --set measure.11.points=0
wrong 'unknown key "measure.6.radus"; did you mean "measure.6.radius"' --set measure.6.radus=1
wrong 'measure.0.at is read only while measure.0.quantity is' --set 'measure.0.at=[0, 0, 0]'
wrong '"measure.0.at" is missing' --set 'measure=[{"quantity": "pressure"}]'
wrong 'measure.0 is "energy" already' --set measure.1.name=energy
wrong 'which would break the csv file' --set 'measure.1.name=a, b'
wrong 'measure.6.at: x = 9 m is outside the domain' --set 'measure.6.at=[9, 0, 0]'
wrong 'measure.7.max is not above measure.7.min along z' --set 'measure.7.max=[1, 1, 0]'
wrong 'is periodic, no wall' --set 'domain.walls={"-x": "periodic", "+x": "periodic"}'
wrong 'would make 3e+08 rows' --set time.measure=1e-9
wrong 'above 0' --set time.measure=0
sed 's/"height"/"heigth"/' "$scene" >"$work/bad.json"
"$SPH" "$work/bad.json" --check >"$work/out" 2>&1
[ $? = 2 ] && grep -qF "$work/bad.json:10:41: measure.9.quantity: \"heigth\" is unknown;" \
    "$work/out" && grep -qF 'did you mean "height"' "$work/out"
result $? "an unknown quantity is named with line and column"

"$SPH" "$scene" --write-scene "$work/a.json" >"$work/out" 2>&1 &&
    "$SPH" "$work/a.json" --write-scene "$work/b.json" >>"$work/out" 2>&1 &&
    cmp "$work/a.json" "$work/b.json" >>"$work/out" 2>&1
result $? "the scene in force loads to itself"
"$SPH" -q "$work/a.json" --threads 1 -o "$csv" >"$work/out" 2>&1 &&
    cmp "$work/first.csv" "$csv" >>"$work/out"
result $? "and measures the same"

# An earlier file stays until there is a result; a run that ends early keeps its rows.
echo earlier >"$csv"
"$SPH" -q "$scene" -o "$csv" -o "$work/no/such/x.csv" >"$work/out" 2>&1
[ $? = 4 ] && [ "$(cat "$csv")" = earlier ] && [ ! -e "$csv.part" ]
result $? "a failed start leaves an earlier file alone"
endless="--end 3000 --set time.measure=0.01 --threads 1"
"$SPH" -q "$scene" $endless -o "$csv" >"$work/out" 2>&1 &
pid=$!
until [ "$(wc -l 2>/dev/null <"$csv.part" || echo 0)" -gt 3 ] || ! kill -0 $pid; do sleep 0.1; done
[ "$(cat "$csv")" = earlier ]
result $? "an earlier file stays while the run goes on"
kill -INT $pid
wait $pid
rc=$?
[ $rc = 130 ] && [ ! -e "$csv.part" ] && [ "$(sed -n 2p "$csv" | cut -d, -f2)" = 0 ]
result $? "SIGINT finishes the file (got $rc)"
rm -f "$csv"
"$SPH" -q "$scene" $endless -o "$csv" >"$work/out" 2>&1 &
pid=$!
until [ "$(wc -l 2>/dev/null <"$csv.part" || echo 0)" -gt 3 ] || ! kill -0 $pid; do sleep 0.1; done
kill -KILL $pid
wait $pid 2>/dev/null
awk -F, 'NR == 1 {n = NF} NF != n {bad = 1} END {exit bad || NR < 4}' "$csv.part"
result $? "a killed run leaves whole rows in the .part file"
run --solver wcsph --set solver.sound_speed=0.5 -o "$csv"
[ $? = 1 ] && [ "$(tail -n +2 "$csv" | wc -l)" -ge 1 ]
result $? "a run that is stopped keeps its rows"
if "$SPH" list renderers | grep -qE '^ *(egl|osmesa)'; then
    run -o "$csv" -o "$work/f-%03d.png" --set time.measure=0.03
    [ $? = 0 ] && [ "$(tail -n +2 "$csv" | wc -l)" = 11 ] && [ "$(ls "$work"/f-*.png | wc -l)" = 7 ]
    result $? "rows and pictures of one run, each at its times"
fi
echo "1..$n"
