#!/bin/sh
# Tests the plan of every shipped scene against tests/plans/NAME.txt.
# After a wanted change of plans: make, then UPDATE=1 tests/run t601_plans, and read git diff.
. tests/tap.sh
for scene in scenes/*.json scenes/*/*.json; do
    name=$(basename "$scene" .json)
    "$SPH" "$scene" --plan -o film.mp4 >"$work/plan" 2>"$work/out"
    result $? "$name: --plan"
    [ -z "${UPDATE:-}" ] || cp "$work/plan" "tests/plans/$name.txt"
    diff -u "tests/plans/$name.txt" "$work/plan" >"$work/out" 2>&1
    result $? "$name: the plan is as expected"
done
missing=$(for plan in tests/plans/*.txt; do
    ls scenes/"$(basename "$plan" .txt)".json scenes/*/"$(basename "$plan" .txt)".json 2>/dev/null |
        grep -q . || echo "$plan"
done)
[ -z "$missing" ]
result $? "no plan without a scene: $missing"
echo "1..$n"
