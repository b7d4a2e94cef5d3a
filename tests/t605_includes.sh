#!/bin/sh
# Tests that includes point only downwards: a room sees the rooms before it, and only main exits.
. tests/tap.sh
order="base device scene particles grid solver backend render compare encode run study tools main.c"

# position ROOM: its place in the order
position() { echo "$order" | tr ' ' '\n' | grep -nx -e "$1" | cut -d: -f1; }
# edges: "FILE ROOM INCLUDED-ROOM" of every #include "room/..." in src
edges() {
    grep -rn '^#include "' src | sed 's/:[0-9]*:#include "/ /; s/".*//' | while read -r file include; do
        room=${file#src/}
        echo "$file ${room%%/*} ${include%%/*} $include"
    done
}
edges >"$work/edges"
[ "$(wc -l <"$work/edges")" -gt 100 ]
result $? "includes are found"

# Shaders are made at build time and have no room.
while read -r file room to include; do
    [ "$to" != shaders ] || continue
    from=$(position "$room") into=$(position "$to")
    if [ -z "$from" ] || [ -z "$into" ] || [ "$into" -gt "$from" ]; then
        echo "$file includes $include"
    fi
done <"$work/edges" >"$work/out"
[ ! -s "$work/out" ]
result $? "includes point downwards"

# never ROOM ALLOWED...: the room includes nothing else
only() {
    room=$1
    shift
    allowed=" $* $room shaders "
    awk -v room="$room" -v allowed="$allowed" \
        '$2 == room && !index(allowed, " " $3 " ") {print $1 " includes " $4}' \
        "$work/edges" >"$work/out"
    [ ! -s "$work/out" ]
    result $? "$room includes only: $*"
}
only base
only device base
only scene base
only compare base
only encode base compare
only render base device scene particles
only particles base scene
only grid base particles
only solver base scene particles
only study base scene particles run

grep -rnwE '_?exit *\(|quick_exit *\(|abort *\(' src --include='*.[ch]' |
    grep -vE '^src/main\.c:|/\*.*exit.*\*/|_exit\(STATUS_INTERRUPTED\)' >"$work/out"
[ ! -s "$work/out" ]
result $? "only main exits, and a second interrupt"
grep -rnE 'include *[<"](mpi\.h|cuda|cub/|cooperative_groups)' src --include='*.[ch]' |
    grep -vE '^src/(backend/(mpi|cuda)|render/cuda|device)/' >"$work/out"
[ ! -s "$work/out" ]
result $? "mpi.h and CUDA headers stay in their rooms"
echo "1..$n"
