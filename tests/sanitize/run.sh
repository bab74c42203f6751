#!/usr/bin/env bash
# Builds the tests with sanitizers, in builds of their own, and runs them; what is reported fails.
#   run.sh address  AddressSanitizer, LeakSanitizer and UndefinedBehaviorSanitizer, in build/address
#   run.sh thread   ThreadSanitizer, in build/thread
#   run.sh          both
# OSG, the driver and other libraries are as they are installed. What is reported of them alone is
# named in leaks.supp and threads.supp.

cd "$(dirname "$0")/../.."
. .ci/setup.sh

suppressions="$PWD/tests/sanitize"

# sanitize NAME FLAGS TESTS EXCEPT PROGRAM...: builds programs and runs tests, both by regular
# expressions.
sanitize() {
    local name=$1 flags=$2 tests=$3 except=$4
    shift 4
    say "building $* in build/$name"
    cmake -S . -B "build/$name" -G Ninja -DCMAKE_BUILD_TYPE=None \
        -DOSGWATERREFLECT_BUILD_APPLICATIONS=OFF \
        -DCMAKE_CXX_FLAGS="-O1 -g1 -fno-omit-frame-pointer -fno-sanitize-recover=all $flags" \
        >/dev/null || fail "cmake could not configure build/$name"
    cmake --build "build/$name" --target "$@" || fail "the build failed"
    say "testing in build/$name"
    ctest --test-dir "build/$name" -R "$tests" -E "$except" --no-tests=error \
        --output-on-failure -j "$(nproc)" || fail "tests failed in build/$name"
}

# Left out: two that search exhaustively for every pixel, over five minutes each, by code that unit
# tests run, too. test_gpu's check of the memory held says nothing here: leaks are looked for.
address() {
    export ASAN_OPTIONS="strict_string_checks=1:detect_stack_use_after_return=1"
    export LSAN_OPTIONS="suppressions=$suppressions/leaks.supp:print_suppressions=0"
    export UBSAN_OPTIONS="print_stacktrace=1"
    sanitize address "-fsanitize=address,undefined,float-cast-overflow" \
        '^(unit|gpu|image|battery):' '^gpu: ?(sequential search finds what|a branch ahead of)' \
        test_unit test_gpu test_image test_battery
}

# Only tests in which several threads run code of ours. llvmpipe draws in the thread that calls it:
# what its own threads do is not seen, and would be reported.
thread() {
    export LP_NUM_THREADS=0
    export TSAN_OPTIONS="suppressions=$suppressions/threads.supp:history_size=7"
    sanitize thread "-fsanitize=thread" \
        '^gpu: ?(waters that change|all threading|a frame is copied while)|^bench: ?(image truth|truth|tessell|picture)' \
        '^bench: osgwaterbench' \
        test_gpu test_bench
}

case "$*" in
"") chosen="address thread" ;;
address | thread) chosen=$1 ;;
*) fail "expected address, thread or nothing, got $*" ;;
esac
install_packages
for sanitizer in $chosen; do
    "$sanitizer"
done
