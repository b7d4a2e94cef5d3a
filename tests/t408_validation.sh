#!/bin/sh
# Tests that each validation scene and each study is valid, and that a study's default method is the
# scene as it is shipped.
. tests/tap.sh
for scene in scenes/validation/*.json; do
    "$SPH" "$scene" --check >"$work/out" 2>&1
    result $? "$scene is valid"
done
# A budget of no time: everything is read and checked, nothing is run.
left_out() { # FILTER STUDY [OPTION]: all that the filter finds in the results is left out
    filter=$1
    shift
    "$SPH" study "$@" -o "$work/study" --budget 0.001s -q >"$work/out" 2>&1 &&
        cat "$work/study"/*.json | jq -es "[.[] | $filter] | length > 0 and all(. == \"left out\")" \
            >>"$work/out" 2>&1
    result $? "$1 is valid"
    rm -rf "$work/study"
}
for study in studies/*.json studies/[!gs]*/*.json studies/se*/*.json tests/studies/*.json; do
    left_out '.points[].outcome' "$study"
done
for study in studies/gpu/*.json; do # without a GPU that is all there is to say against them
    if "$SPH" list devices | grep -q cuda:0; then
        left_out '.points[].outcome' "$study"
        continue
    fi
    "$SPH" study "$study" -o "$work/study" --budget 0.001s -q >"$work/out" 2>&1
    [ $? = 3 ] && grep -qE 'there is no GPU|not in this build' "$work/out"
    result $? "$study needs a GPU"
done
for map in studies/stability/*.json; do
    left_out '.cells[].kind' "$map" --stability
done
echo "1..$n"
