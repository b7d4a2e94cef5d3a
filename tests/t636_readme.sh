#!/bin/sh
# Tests that the figures and tables of the README are replaced all together, or not at all.
. tests/tap.sh
out=$work/made
cp README.md "$work/README.md"
tables=$(sed -n 's/^<!-- made by make study: \(.*\) -->$/\1/p' README.md)
for table in $tables; do
    mkdir -p "$out/$(dirname "$table")"
    printf '| %s & its | rows |\n|---|---|\n| 1 | 2 |\n' "$table" >"$out/$table"
done
[ "$(echo "$tables" | wc -l)" -ge 4 ] && [ "$(grep -c '^<!-- end -->$' README.md)" = "$(echo "$tables" | wc -l)" ]
result $? "the README has markers for tables, each with its end"
sed -n '/^figures="/,/^"/p' tools/readme-figures | grep png | while read -r name file; do
    mkdir -p "$out/$(dirname "$file")"
    echo "$name" >"$out/$(echo "$file" | sed 's/\*/x/')"
    grep -q "(docs/$name)" README.md || echo "$name is not in the README"
done >"$work/out"
[ ! -s "$work/out" ]
result $? "each figure is in the README"
tools/readme-figures "$out" "$work/README.md" "$work/docs" >"$work/out" 2>&1
result $? "figures and tables are replaced"
for table in $tables; do
    grep -qF "| $table & its | rows |" "$work/README.md" || echo "$table is missing"
done >"$work/out"
grep -q 'study-tank.png' "$work/docs/study-tank.png" || echo "no figure" >>"$work/out"
[ ! -s "$work/out" ]
result $? "they are the new ones"
outside() { sed '/^<!-- made by make study/,/^<!-- end -->$/d' "$1"; }
outside README.md >"$work/a" && outside "$work/README.md" | diff "$work/a" - >"$work/out"
result $? "nothing else has changed"
cp "$work/README.md" "$work/once"
tools/readme-figures "$out" "$work/README.md" "$work/docs" >"$work/out" 2>&1 && cmp "$work/once" "$work/README.md" >>"$work/out" 2>&1
result $? "a second time changes nothing"

# kept WHAT: the script fails, and README and figures stay
kept() {
    rm -rf "$work/docs"
    tools/readme-figures "$out" "$work/README.md" "$work/docs" >"$work/out" 2>&1
    [ $? = 1 ] && grep -q 'nothing was changed' "$work/out" && cmp -s "$work/now" "$work/README.md" && [ ! -e "$work/docs" ]
    result $? "nothing is changed: $1"
}
cp "$work/README.md" "$work/now"
mv "$out/stability" "$work/away"
kept "a figure is missing"
mv "$work/away" "$out/stability"
mv "$out/seeds/summary.md" "$work/away"
kept "a table is missing"
mv "$work/away" "$out/seeds/summary.md"
sed -i '/^<!-- end -->$/d' "$work/README.md"
cp "$work/README.md" "$work/now"
kept "a marker has no end"
echo "1..$n"
