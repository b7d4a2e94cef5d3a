#!/bin/sh
# Tests pictures with lines and text (pdf, svg): the text is text, the same picture as PNG, whole or absent.
. tests/tap.sh
if "$SPH" list encoders | grep -q '^ *pdf.*not in this build'; then
    "$SPH" -q scenes/dambreak.json --at 0 -o "$work/a.pdf" 2>"$work/out"
    [ $? = 3 ] && grep -q "libcairo2-dev" "$work/out" && [ ! -e "$work/a.pdf" ]
    result $? "without cairo it is exit code 3 that says what is missing"
    echo "1..$n"
    exit
fi
cat >"$work/scene.json" <<'X'
{ "title": "Drop & <pool>", "domain": {"min": [0, 0, 0], "max": [0.5, 0.5, 0.5]},
  "particles": {"spacing": 0.0625}, "fluids": [{}],
  "bodies": [{"shape": "box", "min": [0, 0, 0], "max": [0.25, 0.25, 0.5]}],
  "labels": [{"text": "Re = 100", "at": "top-right"}],
  "color": {"by": "pressure", "legend": true}, "render": {"axes": true, "scale_bar": true, "title": true},
  "time": {"end": 0.4}, "movie": {"size": [320, 180], "fps": 100} }
X
# shoot ARGUMENTS...
shoot() {
    "$SPH" -q "$work/scene.json" --renderer cpu --threads 1 "$@" >"$work/text" 2>"$work/out"
}
# near A B: whether two pictures differ by text's edges at most (FLIP mean; without the text it is 0.042)
near() {
    "$SPH" compare "$1" "$2" >"$work/out" 2>&1
    awk '$1 == "flip" {found = 1; bad = $2 > 0.02} END {exit !found || bad}' "$work/out"
}
# lines FILE TEXT...: whether each is a line of it
lines() {
    file=$1
    shift
    for line in "$@"; do
        grep -qxF "$line" "$file" || return 1
    done
}

shoot --at 0.2 -o "$work/a.pdf" -o "$work/a.svg" -o "$work/a.png"
result $? "one picture in three kinds"
pdftotext "$work/a.pdf" "$work/out" &&
    lines "$work/out" 'Drop & <pool>' 'Re = 100' 'pressure (Pa)' 't = 0.20 s' '0' 'y'
result $? "the text of a pdf is text"
grep -q "at target" "$work/out"
result $? "that of the scale bar, too"
shoot --at 0 -o "$work/c.pdf" --set camera.projection=orthographic && pdftotext "$work/c.pdf" "$work/out" &&
    grep -qxE '[0-9]+ (cm|mm|m)' "$work/out" && ! grep -q target "$work/out"
result $? "which is true everywhere in an orthographic picture, and says a length only"
pdfinfo "$work/a.pdf" >"$work/out" && grep -q 'Title: *Drop & <pool>$' "$work/out" &&
    grep -q 'Creator: *sph-render' "$work/out" && grep -q 'Page size: *240 x 135 pts' "$work/out" &&
    ! grep -q CreationDate "$work/out"
result $? "a pdf has title, creator, size, and no date"
grep -q '<title>Drop &amp; &lt;pool></title>' "$work/a.svg" && grep -q 'width="320px" height="180px"' "$work/a.svg"
result $? "an svg has title and size"
[ "$(grep -c '<image' "$work/a.svg")" = 1 ] && grep -q 'linearGradient' "$work/a.svg"
result $? "only particles are an image"
pdftocairo -png -singlefile -r 96 "$work/a.pdf" "$work/pdf" && near "$work/a.png" "$work/pdf.png"
result $? "a pdf looks like the png"
rsvg-convert "$work/a.svg" -o "$work/svg.png" && near "$work/a.png" "$work/svg.png"
result $? "an svg looks like the png"
shoot --at 0.2 -o "$work/b.pdf" && shoot --at 0.2 -o "$work/b.svg" && shoot --at 0.2 -o "$work/c.svg" &&
    cmp "$work/a.pdf" "$work/b.pdf" >>"$work/out" && cmp "$work/b.svg" "$work/c.svg" >>"$work/out"
result $? "again they are the same bytes"

shoot --at 0.2 -o "$work/c.pdf" --set render.transparent=true && pdfimages -list "$work/c.pdf" >"$work/out" &&
    grep -q smask "$work/out"
result $? "a transparent pdf has an alpha channel"
shoot --at 0,0.1,0.2 -o "$work/s-%02d.pdf" -o "$work/s-%02d.svg" &&
    [ "$(cd "$work" && echo s-*)" = "s-00.pdf s-00.svg s-01.pdf s-01.svg s-02.pdf s-02.svg" ]
result $? "sequences"
shoot --sheet 2x2 -o "$work/sheet.pdf" -o "$work/sheet.png" && pdftotext "$work/sheet.pdf" "$work/text" &&
    [ "$(grep -c '^Re = 100' "$work/text") $(grep -c '^t = 0.400 s' "$work/text")" = "4 1" ]
result $? "a sheet's text is text"
pdftocairo -png -singlefile -r 96 "$work/sheet.pdf" "$work/pdf" && near "$work/sheet.png" "$work/pdf.png"
result $? "a sheet looks like the png"

shoot -o "$work/film.pdf"
[ $? = 2 ] && grep -q "film-%04d.pdf" "$work/out" && [ ! -e "$work/film.pdf" ]
result $? "a film under one name is exit code 2"
for kind in pdf svg; do
    echo earlier >"$work/k.$kind"
    (ulimit -f 1; "$SPH" -q "$work/scene.json" --threads 1 --at 0 -o "$work/k.$kind" 2>&1; echo "rc=$?") |
        cat >"$work/out"
    grep -q "rc=4" "$work/out" && grep -q "File too large" "$work/out" && grep -q earlier "$work/k.$kind" &&
        [ "$(cd "$work" && echo k.$kind*)" = "k.$kind" ]
    result $? "a $kind that cannot be written is exit code 4, and the earlier file is intact"
done
echo "1..$n"
