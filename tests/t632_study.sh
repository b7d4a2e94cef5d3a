#!/bin/sh
# Tests studies from end to end: tables, figures and pages of runs of one particle whose errors are known.
. tests/tap.sh
# The particle's centre is half a spacing above 0.2 m and stays there: the height errs by d/2.
cat >"$work/scene.json" <<'END'
{ "title": "One particle", "gravity": [0, 0, 0],
  "domain": {"min": [0, 0, 0], "max": [1, 1, 1]},
  "particles": {"spacing": 0.1},
  "fluids": [{"name": "fluid", "density": 1000, "viscosity": 0.001}],
  "bodies": [{"shape": "box", "min": [0.2, 0.2, 0.2], "max": [0.3, 0.3, 0.3]}],
  "solver": {"method": "isph"},
  "time": {"end": 0.02}, "movie": {"size": [64, 36], "fps": 50} }
END
printf 'time (s),height,low,high\n0,0.2,0.19,0.21\n1,0.2,0.19,0.21\n' >"$work/data.csv"
head='"scene": "scene.json", "repeats": 1, "interval": 0.01, "measure": [{"quantity": "extent"}]'
cat >"$work/study.json" <<END
{ "title": "Height <of> one | particle", $head,
  "errors": [
    {"name": "by value", "column": "extent.y.min", "norm": "final", "asked": 0.1, "reference": {"value": 0.2}},
    {"name": "by formula", "column": "extent.y.min", "norm": "final", "reference": {"formula": "0.2+0*t"}},
    {"name": "by data", "column": "extent.y.min", "norm": "final",
     "reference": {"data": "data.csv", "column": "height", "low": "low", "high": "high"}},
    {"name": "by first", "column": "extent.y.min", "norm": "l2", "reference": "first"},
    {"name": "by run", "column": "extent.y.min", "norm": "max", "reference": "run"}],
  "plot": ["by value"],
  "reference": {"particles.spacing": 0.0125},
  "methods": [{"vary": {"solver.method": ["isph", "wcsph"]}}],
  "ladders": [{"name": "resolution", "set": {"particles.spacing": [0.1, 0.05, 0.025]}},
              {"name": "threads", "set": {"threads": [1, 2]}}] }
END
out=$work/results
formulas=0
"$SPH" study "$work/study.json" -o "$out" -q >"$work/out" 2>&1 || formulas=$?
if [ "$formulas" != 0 ] && grep -q muParser "$work/out"; then # a program without muParser
    sed -i '/by formula/d' "$work/study.json"
    "$SPH" study "$work/study.json" -o "$out" -q >"$work/out" 2>&1
    formulas=$?
else
    formulas_in=1
fi
[ "$formulas" = 0 ]
result $? "a study runs"
jq -e '.points | length == 11 and all(.outcome == "done")' "$out/results.json" >"$work/out" 2>&1
result $? "results.json has the reference and ten points, all done"
[ "$(wc -l <"$out/results.csv")" = 12 ] && [ "$(head -n 1 "$out/results.csv" | grep -c '"by value"')" = 1 ]
result $? "results.csv has a line for each"

# errs NAME VALUES: of isph along the resolutions
errs() {
    jq -e --arg name "$1" --argjson values "$2" '[.points[] | select(.ladder == "resolution" and
        .method == "isph") | .errors[] | select(.name == $name).value] as $v |
        ($v | length) == 3 and ([$v, $values] | transpose | all(((.[0] - .[1]) | fabs) < 1e-5))' \
        "$out/results.json" >"$work/out" 2>&1
    result $? "the error $1 is what it is made to be"
}
errs "by value" '[0.25, 0.125, 0.0625]'
[ -z "${formulas_in:-}" ] || errs "by formula" '[0.25, 0.125, 0.0625]'
errs "by data" '[0.25, 0.125, 0.0625]'
errs "by first" '[0, 0, 0]'
errs "by run" '[0.212121, 0.090909, 0.030303]'
jq -e '[.points[] | select(.ladder == "resolution" and .value != "0.1").order] |
       length == 4 and all((. - 1 | fabs) < 1e-4)' "$out/results.json" >"$work/out" 2>&1
result $? "errors of d/2 are of first order"
jq -e '[.points[].errors[] | select(.name == "by data").spread] | all((. - 0.05 | fabs) < 1e-6)' \
    "$out/results.json" >"$work/out" 2>&1
result $? "a band of data is its spread"
jq -e '[.points[] | select(.front and .ladder == "resolution")] | length >= 1' "$out/results.json" \
    >"$work/out" 2>&1
result $? "some point is on the front"

grep -q '^# Height \\<of\\> one \\| particle' "$out/report.md" &&
    grep -q '^| isph | 0.05 |.*\*\*12.5 %\*\*' "$out/report.md" &&
    grep -q '^| wcsph | 0.025 |.* 6.25 %' "$out/report.md" &&
    grep -q 'time to 1 % error' "$out/report.md" && grep -q 'not reached, least 6.25 %' "$out/report.md" &&
    grep -q 'by value, asked at most 10 %.*met by isph (6.25 %); wcsph (6.25 %)' "$out/report.md" &&
    grep -q 'Default on the front. isph (the scene.s own settings)' "$out/report.md" &&
    grep -q 'speed-up' "$out/report.md"
result $? "report.md has rows, bounds and verdicts"
command=$(sed -n 's/^- isph, particles.spacing 0.05: `sph-render \(.*\)`$/\1/p' "$out/report.md")
program=$(realpath "$SPH")
[ -n "$command" ] && (cd "$out" && eval "'$program' $command -q") >"$work/out" 2>&1 &&
    jq -e --slurpfile again "$out/report.json" '.points[] | select(.ladder == "resolution" and
       .method == "isph" and .value == "0.05").steps == $again[0].steps' "$out/results.json" >"$work/out" 2>&1
result $? "a point's command makes its run again"
grep -q '<title>Height &lt;of&gt; one | particle</title>' "$out/index.html" &&
    grep -q '<b>12.5 %</b>' "$out/index.html" && grep -q 'data:image/png;base64,' "$out/index.html" &&
    ! grep -qE '(src|href)="?(https?:|/|\.)' "$out/index.html"
result $? "index.html has rows and pictures, and asks for no other file"
if command -v gnuplot >"$work/out" 2>&1; then
    for plot in 1-resolution-by-value-time 2-resolution-by-value-pairs 3-threads-time; do
        [ -s "$out/plots/$plot.png" ] && [ -s "$out/plots/$plot.svg" ] && [ -s "$out/plots/$plot.dat" ]
        result $? "$plot is drawn"
    done
    grep -q 'data:image/svg+xml;base64,' "$out/index.html"
    result $? "the page has figures"
    rm "$out/plots/3-threads-time.png"
    (cd "$out/plots" && gnuplot 3-threads-time.gp) >"$work/out" 2>&1 && [ -s "$out/plots/3-threads-time.png" ]
    result $? "a figure's script draws it again by hand"
fi

ends() { find "$1/runs" -name '*.end' -exec stat -c '%n %Y %Z %i' {} + | sort; }
ends "$out" >"$work/before"
PATH=/nowhere "$SPH" study "$work/study.json" -o "$out" >"$work/out" 2>&1
code=$?
ends "$out" >"$work/after"
[ "$code" = 0 ] && cmp -s "$work/before" "$work/after"
result $? "the same command runs nothing again"
[ "$(grep -c gnuplot-nox "$work/out")" = 1 ] && [ -s "$out/report.md" ]
result $? "without gnuplot one message names its package, and the rest is written"

# A time that others disturbed: the run is made again, and the median is without it.
folder=$(jq -r '.points[] | select(.ladder == "resolution" and .method == "wcsph" and .value == "0.025").folder' "$out/results.json")
jq '.seconds.solve = 9' "$out/$folder/r0.json" >"$work/slow.json" && mv "$work/slow.json" "$out/$folder/r0.json"
"$SPH" study "$work/study.json" -o "$out" -q >"$work/out" 2>&1 && [ -e "$out/$folder/r1.end" ] &&
    jq -e '.points[] | select(.ladder == "resolution" and .method == "wcsph" and .value == "0.025") |
        (.wall | length == 2) and .wall[0] == 9 and .disturbed >= 1' "$out/results.json" >>"$work/out" 2>&1 &&
    grep -q 'runs were disturbed' "$out/report.md" && ! grep -q '| wcsph | 0.025 |.* 9 |' "$out/report.md"
result $? "a disturbed run is made again and left out of the median"

# One point is soon done, the other lasts.
cat >"$work/long.json" <<END
{ "title": "Long", $head,
  "errors": [{"column": "extent.y.min", "reference": {"value": 0.2}}],
  "ladders": [{"name": "end", "set": {"time.end": [0.02, 1e5], "particles.spacing": [0.1, 0.05]}}] }
END
# begin: starts it, $child, and waits for the second point
begin() {
    "$SPH" study "$work/long.json" -o "$work/long" -q >"$work/out" 2>&1 &
    child=$!
    for _ in $(seq 100); do
        [ "$(find "$work/long/runs" -name 'r0.log' 2>/dev/null | wc -l)" -ge 2 ] && break
        sleep 0.1
    done
}
# alone: whether no run of it is left, after a moment
alone() {
    for _ in $(seq 30); do
        pgrep -f "$work/long/runs" >/dev/null || return 0
        sleep 0.1
    done
    return 1
}
begin
kill -INT "$child"
wait "$child"
[ $? = 130 ] && alone
result $? "an interrupt ends with 130 and leaves no run"
begin
kill -KILL "$child"
wait "$child" 2>/dev/null
alone
result $? "a kill leaves no run"
ends "$work/long" >"$work/before"
"$SPH" study "$work/long.json" -o "$work/long" --budget 1s -q >"$work/out" 2>&1
code=$?
ends "$work/long" | grep -F -x -f "$work/before" >"$work/after"
[ "$code" = 0 ] && [ "$(wc -l <"$work/before")" = 1 ] && cmp -s "$work/before" "$work/after" &&
    jq -e '[.points[].outcome] | .[0] == "done" and .[1] == "left out"' \
        "$work/long/results.json" >"$work/out" 2>&1
result $? "it goes on after a kill, as far as its budget goes"

sed 's/"repeats": 1/"repeats": 3/; s/0.02, 1e5/0.02, 2e4/' "$work/long.json" >"$work/budget.json"
"$SPH" study "$work/budget.json" -o "$work/budget" -b 0.001s -q >"$work/out" 2>&1 &&
    grep -q '### Left out' "$work/budget/report.md" && grep -q 'budget is used up' "$work/budget/report.md"
result $? "what a budget leaves out is said"

# The coarser of two would reach its own image.
sed 's/"max": \[1, 1, 1\]/"max": [1, 1, 1], "walls": "periodic"/; s/"min": \[0.2.*\]}/"min": [0, 0, 0], "max": [1, 1, 1]}/' \
    "$work/scene.json" >"$work/periodic.json"
sed 's/"time.end": \[0.02, 1e5\], //; s/\[0.1, 0.05\]/[0.2, 0.1]/; s/scene.json/periodic.json/' \
    "$work/long.json" >"$work/stops.json"
"$SPH" study "$work/stops.json" -o "$work/stops" -q >"$work/out" 2>&1 &&
    jq -e '.points | map(.outcome) == ["stopped", "done"]' "$work/stops/results.json" >"$work/out" 2>&1 &&
    grep -q 'spacing 0.2 (ladder end): stopped, .*its own image' "$work/stops/report.md"
result $? "a run that stops is a point, and its cause is said"

python3 -c 'import csv, sys; sys.exit(len({len(row) for row in csv.reader(open(sys.argv[1]))}) != 1)' \
    "$work/stops/results.csv" >"$work/out" 2>&1
result $? "every line of results.csv has as many fields, also of what stopped"
sed 's/"norm": "final", "asked": 0.1, "reference": {"value": 0.2}/"norm": "max", "reference": {"value": 0}/' \
    "$work/study.json" >"$work/zero.json"
"$SPH" study "$work/zero.json" -o "$work/zero" --repeats 1 >"$work/out" 2>&1 &&
    grep -q 'by value: the reference is 0 or no number' "$work/out" &&
    jq -e '[.points[] | select(.ladder != "reference").outcome] | all(. == "stopped")' \
        "$work/zero/results.json" >>"$work/out" 2>&1
result $? "an error that would be a part of 0 is none, and that is said"
"$SPH" study "$work/long.json" "$work/long.json" -o "$work/twice" >"$work/out" 2>&1
[ $? = 2 ] && [ ! -e "$work/twice" ]
result $? "refused: the same study twice"

# Seeds: a disordered block, whose start extent is chance.
sed 's/"max": \[0.3, 0.3, 0.3\]}/"max": [0.5, 0.5, 0.5], "jitter": 0.1, "seed": 4}/' "$work/scene.json" >"$work/jitter.json"
cat >"$work/seeds.json" <<END
{ "title": "Seeds", "scene": "jitter.json", "repeats": 1, "interval": 0.01, "seeds": 3,
  "measure": [{"quantity": "extent"}],
  "errors": [{"name": "left end", "column": "extent.x.min", "norm": "final", "reference": {"value": 0.25}},
             {"name": "against a finer run", "column": "extent.x.min", "norm": "final", "reference": "run"}],
  "reference": {"particles.spacing": 0.03},
  "ladders": [{"name": "resolution", "set": {"particles.spacing": [0.1, 0.075, 0.05]}}] }
END
"$SPH" study "$work/seeds.json" -o "$work/seeds" -q >"$work/out" 2>&1 &&
    [ "$(find "$work/seeds/runs" -name 'r0.end' | wc -l)" = 10 ] &&
    jq -e '[.points[] | select(.ladder == "resolution")] | length == 3 and all(
        (.seeds | length == 3 and ([.[].state] | unique | length == 3)) and
        ((.errors[0].value - ([.seeds[].errors[0].value] | add / 3)) | fabs < 1e-7) and
        .errors[0].runs == 3 and .errors[0].deviation > 0 and
        .errors[0].least_size <= .errors[0].mean_size and .errors[0].mean_size <= .errors[0].most_size)' \
        "$work/seeds/results.json" >>"$work/out" 2>&1
result $? "with seeds each point is the mean of different runs"
jq -e '.convergence | length == 1 and .[0].method == "as the scene says" and .[0].error == "against a finer run"' \
    "$work/seeds/results.json" >"$work/out" 2>&1 &&
    grep -q 'observed order' "$work/seeds/report.md" && grep -q ' ± ' "$work/seeds/report.md" &&
    grep -q '"left end: deviation"' "$work/seeds/results.csv" &&
    { [ ! -s "$work/seeds/plots/1-resolution-left-end-time.png" ] ||
      grep -q xerrorbars "$work/seeds/plots/1-resolution-left-end-time.gp"; }
result $? "report, table and figure have their spread, and the limit against the finer run"
sed 's/jitter.json/scene.json/' "$work/seeds.json" >"$work/even.json"
"$SPH" study "$work/even.json" -o "$work/even" >"$work/out" 2>&1
[ $? = 2 ] && grep -q 'no body has "jitter"' "$work/out" && [ ! -e "$work/even" ]
result $? "refused: seeds of a scene in which nothing is random"

# Several studies: times beside others', settings, and every point once before any is repeated.
cat >"$work/times.json" <<END
{ "title": "Times", $head,
  "ladders": [{"name": "threads", "set": {"threads": [1, 2]}, "steps": 1000,
               "others": [{"name": "theirs", "seconds": [12.5, null]}]}] }
END
"$SPH" study "$work/times.json" "$work/study.json" -o "$work/both" --budget 2m --repeats 2 -q >"$work/out" 2>&1 &&
    grep -q '^Measured 20..-..-.. on .* processors, by sph-render' "$work/both/summary.md" &&
    grep -q '^Times: wall time, s, for 1000 steps' "$work/both/summary.md" &&
    grep -q '^| \*theirs\* | 12.5 | – |$' "$work/both/summary.md" &&
    grep -qF '| Height \<of\> one \| particle | by value | < 10 % | **+25 %** | **+25 %** |' "$work/both/summary.md"
result $? "a summary has errors, and times beside those of others"
find "$work/both" -name 'r0.end' -exec stat -c '%.9Y' {} + | sort -n | tail -n 1 >"$work/out"
find "$work/both" -name 'r1.end' -exec stat -c '%.9Y' {} + | sort -n | head -n 1 >>"$work/out"
[ "$(wc -l <"$work/out")" = 2 ] && sort -n -c "$work/out" 2>>"$work/out"
result $? "within a budget every point of all studies runs once before any is repeated"
[ ! -e "$work/both/settings.md" ]
result $? "no table of settings where there are none"

# refused LINE:COLUMN WHAT: study.json with a sed expression is refused there, and nothing is written
refused() {
    sed "$3" "$work/study.json" >"$work/bad.json"
    "$SPH" study "$work/bad.json" -o "$work/bad" >"$work/out" 2>&1
    [ $? = 2 ] && grep -q "bad.json:$1: " "$work/out" && [ ! -e "$work/bad" ]
    result $? "refused: $2"
}
refused '[0-9]*:[0-9]*' "an unknown key" 's/"title"/"titel"/'
refused '[0-9]*:[0-9]*' "an unknown norm" 's/"norm": "l2"/"norm": "l3"/'
refused '[0-9]*:[0-9]*' "a figure that is none" 's/"name": "threads",/"name": "threads", "figure": "pie",/'
refused '[0-9]*:[0-9]*' "a ladder of unequal lists" 's/"threads": \[1, 2\]/"threads": [1, 2], "time.cfl": [0.1]/'
refused '[0-9]*:[0-9]*' "a key that scenes do not have" 's/"particles.spacing": \[/"particles.spacin": [/'
refused '[0-9]*:[0-9]*' "no errors" 's/"errors"/"measured"/'
refused '[0-9]*:[0-9]*' "a column that is not measured" 's/"column": "extent.y.min"/"column": "extent.y.mid"/'
refused '[0-9]*:[0-9]*' "data that are not there" 's/data.csv/no.csv/'
refused '[0-9]*:[0-9]*' "a column that data lack" 's/"column": "height"/"column": "depth"/'
refused '[0-9]*:[0-9]*' "two references at once" 's/{"value": 0.2}/{"value": 0.2, "data": "data.csv", "column": "height"}/'
refused '[0-9]*:[0-9]*' "a figure of an error that is none" 's/"plot": \["by value"\]/"plot": ["by guess"]/'
refused '[0-9]*:[0-9]*' "two ladders of one name" 's/"name": "threads"/"name": "resolution"/'
refused '[0-9]*:[0-9]*' "no time for a run" 's/"plot"/"limit": 0, "plot"/'
if [ -n "${formulas_in:-}" ]; then
    refused '[0-9]*:[0-9]*' "a formula that is none" 's/0.2+0\*t/0.2+(t/'
fi
refused '1:[0-9]*' "a file that is cut off" '2,$d'
echo "1..$n"
