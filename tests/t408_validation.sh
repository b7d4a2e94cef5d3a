#!/bin/sh
# Tests the exact solutions that validation compares with, and that each of its scenes is valid.
. tests/tap.sh
PYTHONDONTWRITEBYTECODE=1 python3 -m unittest discover -s tests -p 'test_validate_exact.py' \
    >"$work/out" 2>&1
result $? "exact solutions and the reader of measured columns"
for scene in scenes/validation/*.json; do
    "$SPH" "$scene" --check >"$work/out" 2>&1
    result $? "$scene is valid"
done
echo "1..$n"
