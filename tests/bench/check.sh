#!/usr/bin/env bash
# What osgwaterbench does with its command line: check.sh BEHAVIOUR OSGWATERBENCH

set -euo pipefail

bench=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() {
    printf '%s\n' "$*" >&2
    exit 1
}

# It has to end with 1 and to say so, and nothing else, in one line.
refuses() {
    local expected=$1 status=0
    shift
    "$bench" "$@" --output "$work" >"$work/out" 2>"$work/err" || status=$?
    [ "$status" -eq 1 ] || fail "$*: expected status 1, got $status"
    [ "$(wc -l <"$work/err")" -eq 1 ] || fail "$*: expected one line, got: $(cat "$work/err")"
    grep -qF -- "$expected" "$work/err" || fail "$*: expected '$expected', got: $(cat "$work/err")"
}

wrong_options() {
    refuses "expected an experiment (--help has them), got none"
    refuses "got table2" table2
    refuses "--size" accuracy --size 640
    refuses "--size" accuracy --size 0x480
    refuses "--size" accuracy --size 640x480x2
    refuses "--frames" accuracy --frames 1
    refuses "--frames" accuracy --frames many
    refuses "got sea" accuracy --scenes lake,sea
    refuses "got sea" cpu --only sea
    refuses "--colour" accuracy --colour
}

help() {
    "$bench" --help >"$work/out"
    for word in table1 accuracy rivals scaling borders added cpu --quick --scenes boxes-branch; do
        grep -q -- "$word" "$work/out" || fail "--help: expected $word"
    done
}

# Every experiment runs, prints a table and writes what it found.
runs() {
    "$bench" "$1" --quick --scenes boxes --size 160x120 --frames 2 --output "$work" >"$work/out"
    grep -q "trace" "$work/out" || fail "expected a table, got: $(cat "$work/out")"
    grep -q '"trace_ms"' "$work/$1.json" || fail "expected results, got: $(cat "$work/$1.json")"
}

accuracy() { runs accuracy; }
table1() { runs table1; }
scaling() {
    runs scaling
    for varied in triangles waters corners pixels; do
        grep -q "\"$varied\"" "$work/scaling.json" || fail "expected $varied to be varied"
    done
}
borders() {
    runs borders
    for method in baseline hierarchical "hierarchical, adaptive band" "hierarchical, mirror" \
        "hierarchical, both, band 25 %"
    do
        grep -q "\"$method\"" "$work/borders.json" || fail "expected $method to be measured"
    done
}
added() {
    runs added
    for method in mirror-over-distance view frame "frame, adaptive band"; do
        grep -q "\"$method\"" "$work/added.json" || fail "expected $method to be timed"
    done
}
cpu() {
    "$bench" cpu --quick --frames 2 --output "$work" >"$work/out"
    for capture in view "view, adaptive band" frame "frame, adaptive band" mirror \
        "view and mirror" automatic; do
        grep -q "\"$capture\"" "$work/cpu.json" || fail "expected $capture to be timed"
    done
    grep -q "64 waters on levels, waves, moving eye" "$work/out" ||
        fail "expected a table, got: $(cat "$work/out")"

    "$bench" cpu --quick --frames 2 --output "$work" \
        --only "10 drawables, 1 water, calm, moving eye: frame" >"$work/out"
    [ "$(grep -c '"capture"' "$work/cpu.json")" -eq 2 ] ||
        fail "expected two captures of a frame, got: $(cat "$work/cpu.json")"
}
rivals() {
    runs rivals
    [ -s "$work/rivals-boxes.jpg" ] || fail "expected a picture, got none"
}

"$1"
