#!/bin/sh
# Tests what harms a run from outside: limits, signals, readers that leave, a second run.
. tests/tap.sh
export OMP_WAIT_POLICY=passive
small="scenes/dambreak.json --set particles.spacing=0.08 --end 0.2 --size 640x480 -q"
endless="scenes/dambreak.json --set particles.spacing=0.03 --end 3000 --fps 100 --size 64x64 -q"
draws=false
"$SPH" $small --end 0 -o "$work/0-%d.png" >/dev/null 2>&1 && draws=true
rm -f "$work"/*

# left NAMES...: the names in $work besides `out`
left() {
    [ "$(cd "$work" && ls | grep -vx out | tr '\n' ' ')" = "$*${*:+ }" ] ||
        { ls "$work" >>"$work/out"; return 1; }
}
# code WANTED TEXT NAME: $rc is the wanted one, and the program says TEXT
code() {
    echo "exit code $rc, wanted $1 and: $2" >>"$work/out"
    [ "$rc" = "$1" ] && { [ -z "$2" ] || head -n -1 "$work/out" | grep -qF -e "$2"; }
    result $? "$3: exit code $1"
}

# A file size limit is an error, not a death; what was there stays.
(ulimit -f 0; "$SPH" $small -o null --report "$work/r.json" 2>&1; echo "rc=$?") | cat >"$work/out"
rc=$(sed -n 's/^rc=//p' "$work/out")
code 4 "File too large" "ulimit -f, report"
left; result $? "ulimit -f, report: nothing is left"
if $draws; then
    echo earlier >"$work/k.mp4"
    (ulimit -f 1; "$SPH" $small -o "$work/k.mp4" 2>&1; echo "rc=$?") | cat >"$work/out"
    rc=$(sed -n 's/^rc=//p' "$work/out")
    code 4 "File too large" "ulimit -f, mp4"
    left k.mp4 && grep -q earlier "$work/k.mp4"; result $? "ulimit -f, mp4: the earlier file is intact"
    (ulimit -f 1; "$SPH" $small -o "$work/k-%d.png" 2>&1; echo "rc=$?") | cat >"$work/out"
    rc=$(sed -n 's/^rc=//p' "$work/out")
    code 4 "File too large" "ulimit -f, png"
    left k.mp4; result $? "ulimit -f, png: nothing is left"
    rm -f "$work/k.mp4"
fi

# What is printed must arrive.
if [ -c /dev/full ]; then
    for what in "--plan" "--check" "--write-scene -"; do
        "$SPH" scenes/dambreak.json $what >/dev/full 2>"$work/out"; rc=$?
        code 4 "No space left" "$what to a full disk"
    done
    for what in "list" "bench scenes/dambreak.json --steps 1" "bench scenes/dambreak.json --steps 1 --json"; do
        "$SPH" $what >/dev/full 2>"$work/out"; rc=$?
        code 4 "standard output" "$what to a full disk"
    done
fi
{ "$SPH" $small --fps 1000 -o hash 2>"$work/out"; echo $? >"$work/rc"; } | head -n 1 >/dev/null
rc=$(cat "$work/rc"); rm "$work/rc"
code 4 "Broken pipe" "a reader of hashes that leaves"

# A report that has no place is refused before the run.
timeout 20 "$SPH" $endless -o null --report "$work/no/r.json" >"$work/out" 2>&1; rc=$?
code 4 "create it first" "a report in no directory"

# end SIGNAL: sends it to $pid, which ends, with $rc; one that comes before the handlers is sent again
end() {
    (sleep 30; kill -"$1" $pid; sleep 30; kill -KILL $pid) >/dev/null 2>&1 &
    again=$!
    kill -"$1" $pid
    wait $pid; rc=$?
    kill $again 2>/dev/null
}

# Threads wait politely unless the caller has settings of their own.
# spin NAME=VALUE...: the spin count of a run with these in its environment
spin() {
    env -u OMP_WAIT_POLICY -u GOMP_SPINCOUNT -u KMP_BLOCKTIME "$@" "$SPH" $endless -o null >"$work/out" 2>&1 &
    pid=$!
    sleep 1
    tr '\0' '\n' <"/proc/$pid/environ" | sed -n 's/^GOMP_SPINCOUNT=//p'
    end INT
}
[ "$(spin SPH_UNUSED=1)" = 30000 ]; result $? "threads spin briefly"
[ "$(spin OMP_WAIT_POLICY=passive)" = "" ]; result $? "OMP_WAIT_POLICY of the caller stays"
[ "$(spin GOMP_SPINCOUNT=7)" = 7 ]; result $? "GOMP_SPINCOUNT of the caller stays"

# stop SIGNAL OUT...: ends a run of hours after its first frames; its exit code is in $rc
stop() {
    signal=$1
    shift
    "$SPH" $endless "$@" >"$work/out" 2>&1 &
    pid=$!
    sleep 2
    end "$signal"
}
for signal in INT TERM HUP; do
    stop $signal -o null --report "$work/r.json"
    code 130 "" "SIG$signal"
    jq -e '.frames | length > 0' "$work/r.json" >"$work/out" &&
        jq -e '.end | test("^interrupted at t = ")' "$work/r.json" >"$work/out"
    result $? "SIG$signal: the report says where"
    rm -f "$work/r.json"
done
if $draws; then
    stop TERM -o "$work/t.mp4"
    code 130 "" "SIGTERM, mp4"
    left t.mp4; result $? "SIGTERM finishes the film"
    echo earlier >"$work/t.mp4"
    stop KILL -o "$work/t.mp4"
    grep -q earlier "$work/t.mp4"; result $? "SIGKILL: the earlier film is intact"
    "$SPH" $small -o "$work/t.mp4" >"$work/out" 2>&1; rc=$?
    code 0 "" "a run after a killed one"
    left t.mp4; result $? "and it clears what was left"

    # Two writers: the second is told at once, the first is not disturbed.
    for name in w.mp4 w-%d.png; do
        rm -f "$work"/*
        "$SPH" $endless -o "$work/$name" >/dev/null 2>&1 &
        pid=$!
        sleep 2
        timeout 20 "$SPH" $small -o "$work/../$(basename "$work")/$name" >"$work/out" 2>&1; rc=$?
        code 4 "is being written already" "$name, written by two runs"
        end INT
        code 130 "" "$name, the first of two runs"
        ls "$work" | grep -qE '\.(part|lock)$'
        [ $? = 1 ]; result $? "$name: nothing but the film is left"
    done
    rm -f "$work"/*
    "$SPH" $small -o "$work/s.mp4" -o "$work/./s.mp4" >"$work/out" 2>&1; rc=$?
    code 4 "is being written already" "one file under two spellings"
    left; result $? "and nothing is left"
fi
echo "1..$n"
