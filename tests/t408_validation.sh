#!/bin/sh
# Tests that each validation scene and each study is valid, and that a study's default method is the
# scene as it is shipped.
. tests/tap.sh
for scene in scenes/validation/*.json; do
    "$SPH" "$scene" --check >"$work/out" 2>&1
    result $? "$scene is valid"
done
# A budget of no time: everything is read and checked, nothing is run.
for study in studies/*/*.json tests/studies/*.json; do
    "$SPH" study "$study" -o "$work/study" --budget 0.001s -q >"$work/out" 2>&1 &&
        jq -e '[.points[].outcome] | all(. == "left out")' "$work/study/results.json" >>"$work/out"
    result $? "$study is valid"
    rm -rf "$work/study"
done
echo "1..$n"
