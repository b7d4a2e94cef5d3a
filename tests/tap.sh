# Shared by the shell tests: a directory $work that is removed at the end, and TAP results.
set -u
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
n=0

# result STATUS NAME; on failure shows $work/out
result() {
    n=$((n + 1))
    [ "$1" = 0 ] && echo "ok $n - $2" && return
    echo "not ok $n - $2"
    [ ! -f "$work/out" ] || sed 's/^/# /' "$work/out" | head -n 40
}
