#!/bin/sh
# Loads thousands of damaged scenes under the address and undefined-behaviour sanitizers.
set -u
: "${CC:=gcc}"
: "${BUILD:=build}"
mkdir -p "$BUILD/tests"
if ! $CC -std=c11 -D_GNU_SOURCE -O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all \
    -Isrc -Itests -o "$BUILD/tests/scene_fuzz" tests/scene_fuzz.c src/scene/*.c \
    src/base/error.c src/base/output.c src/base/quote.c src/base/suggest.c src/base/variant.c -lm; then
    echo "not ok 1 - the sanitizer build"
    exit 1
fi
"$BUILD/tests/scene_fuzz" scenes/dambreak.json scenes/double-dam-break.json \
    scenes/drop-into-pool.json
