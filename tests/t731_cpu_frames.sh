#!/bin/sh
# Tests that frames of the cpu renderer have the same bits from both compilers, and that clipping, hiding
# and bad requests do what they say.
. tests/bits.sh
export LC_ALL=C
still="scenes/dambreak.json --set particles.spacing=0.05 --set render.time=false --set render.title=false
       --set color.legend=false --renderer cpu --size 320x180 --end 0.3 --fps 10 -q"
hashes() { "$@" $still -o hash 2>"$work/out"; }
hashes "$SPH" >"$work/first"
[ "$(sort -u -k4 "$work/first" | wc -l)" -ge 4 ]
result $? "frames are drawn and differ"
if [ -n "$second" ]; then
    hashes "$second" >"$work/next" && cmp "$work/first" "$work/next" >>"$work/out" 2>&1
    result $? "the same bits from $other"
    hashes "$second" --isa scalar >"$work/next" && cmp "$work/first" "$work/next" >>"$work/out" 2>&1
    result $? "the same bits from $other, --isa scalar"
fi

# covered ARGUMENTS...: pixels that a still shows anything at
covered() {
    "$SPH" $still --at 0.2 --set render.box=false --set render.transparent=true "$@" \
        -o "$work/still.png" 2>"$work/out" || return 1
    python3 - "$work/still.png" <<'END'
import struct, sys, zlib
data = open(sys.argv[1], "rb").read()
width, height, depth, kind = struct.unpack(">IIBB", data[16:26])
assert (depth, kind) == (8, 6), "no alpha"
at, raw = 8, b""
while at < len(data):
    size, name = struct.unpack(">I4s", data[at:at + 8])
    raw += data[at + 8:at + 8 + size] if name == b"IDAT" else b""
    at += size + 12
raw, row, count = zlib.decompress(raw), bytes(4 * width), 0
for y in range(height):
    method, line = raw[y * (4 * width + 1)], bytearray(raw[y * (4 * width + 1) + 1:(y + 1) * (4 * width + 1)])
    for x in range(4 * width):
        a, b, c = line[x - 4] if x > 3 else 0, row[x], row[x - 4] if x > 3 else 0
        near = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
        line[x] = line[x] + (0, a, b, (a + b) // 2, near)[method] & 255
    row = line
    count += sum(value > 0 for value in line[3::4])
print(count)
END
}
all=$(covered) half=$(covered --set 'render.clip_max=[0.2, 9, 9]')
none=$(covered --set 'render.clip_min=[9, 9, 9]') hidden=$(covered --set fluids.0.visible=false)
title=$(covered --set render.title=true)
slow=$(covered --set 'render.show_range=[0, 0.5]') fast=$(covered --set 'render.show_range=[0.5, 99]')
echo "# pixels: all $all, clipped $half, slow $slow, fast $fast" >"$work/out"
[ "$all" -gt 1000 ] && [ "$half" -lt "$all" ] && [ "$half" -gt 100 ]
result $? "clip_max cuts the fluid: $half of $all pixels"
[ "$title" -gt $((all + 50)) ] || "$SPH" list overlays | grep -q 'not in this build'
result $? "text over nothing is seen: $title of $all pixels"
[ "$none" = 0 ] && [ "$hidden" = 0 ]
result $? "all is clipped or hidden: $none, $hidden pixels"
[ "$slow" -gt 100 ] && [ "$fast" -gt 100 ] && [ "$slow" -lt "$all" ] && [ "$fast" -lt "$all" ]
result $? "show_range hides other values: $slow, $fast of $all pixels"
"$SPH" $still --set render.samples=5 -o "$work/no.png" --at 0 >"$work/out" 2>&1
[ $? = 2 ] && [ ! -e "$work/no.png" ]
result $? "5 samples are refused"
"$SPH" $still --size 40000x64 -o "$work/no.png" --at 0 >"$work/out" 2>&1
code=$?
[ "$code" != 0 ] && [ ! -e "$work/no.png" ]
result $? "a picture too wide is refused (exit $code)"
"$SPH" $still --at 0.1 -o "$work/a.depth.pfm" >"$work/out" 2>&1 &&
    [ "$(head -n 2 "$work/a.depth.pfm" | tr '\n' ' ')" = "Pf 320 180 " ] &&
    [ "$(wc -c <"$work/a.depth.pfm")" = $((16 + 320 * 180 * 4)) ]
result $? "depth as raw floats"
"$SPH" $still --at 0.1 -o "$work/a.pfm" >"$work/out" 2>&1
[ $? = 2 ] && grep -q depth.pfm "$work/out"
result $? "a raw image says what of"
"$SPH" $still -o "$work/b.id.pfm" >"$work/out" 2>&1
[ $? = 2 ] && grep -q '%04d.id.pfm' "$work/out" && [ ! -e "$work/b.id.pfm.new" ]
result $? "raw images of a film are numbered"
echo "1..$n"
