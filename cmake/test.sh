#!/bin/sh
# Runs all of Lixel's tests: prepares this machine, builds everything in build/, tests it, and then
# tests fit, scene and scripts once more, built with the address and undefined-behaviour sanitizers.
#
#     sh cmake/test.sh
#
# The last line counts the tests that passed, failed and were skipped. The exit status is 0 only if
# everything was built, tests ran in both builds, and none failed.
set -eu
cd "$(dirname "$0")/.."

say() { printf '\n== %s\n' "$*"; }
export NINJA_STATUS='[%f of %t, %e s] '

passed=0 failed=0 skipped=0

# run_tests FOLDER CTEST-OPTIONS…: runs a build's tests and adds up their results.
run_tests() {
    folder=$1
    shift
    report=$PWD/$folder/tests.xml
    rm -f "$report"
    status=0
    ctest --test-dir "$folder" --output-on-failure --no-tests=error --parallel 2 \
        --timeout 300 --output-junit "$report" "$@" || status=$?
    for outcome in run fail notrun; do
        count=$(grep -c "<testcase .*status=\"$outcome\"" "$report" || true)
        case $outcome in
        run) passed=$((passed + count)) ;;
        fail) failed=$((failed + count)) ;;
        notrun) skipped=$((skipped + count)) ;;
        esac
    done
    # CTest failed without naming a test: it found none, or could not run them.
    [ "$status" = 0 ] || [ "$failed" != 0 ] || failed=1
}

sh cmake/setup.sh
started=$(date +%s)

say "Building everything"
cmake -S . -B build -DCMAKE_BUILD_TYPE=Release \
    -DLIXEL_BUILD_SAMPLES=ON -DLIXEL_BUILD_TESTS=ON -DLIXEL_SANITIZE=OFF
ninja -C build

say "Testing"
run_tests build

say "Building the tests of fit, scene and scripts with sanitizers"
# Assertions stay on. The samples and their libraries are not needed.
cmake -S . -B build/sanitized -G Ninja -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O1 \
    -DCMAKE_UNITY_BUILD=ON -DLIXEL_BUILD_SAMPLES=OFF -DLIXEL_BUILD_TESTS=ON -DLIXEL_SANITIZE=ON
ninja -C build/sanitized tests/fit/all tests/scene/all tests/script/all

say "Testing fit, scene and scripts with sanitizers"
# OGRE's PNG writer frees with delete[] what malloc gave. Leaks of the libraries that tests load are
# suppressed by the tests themselves (tests/headless/SanitizerOptions.cpp).
export ASAN_OPTIONS=alloc_dealloc_mismatch=0 UBSAN_OPTIONS=print_stacktrace=1
# Of the label material there are the scripts.
for label in fit scene material; do
    run_tests build/sanitized --label-regex "^$label\$"
done

say "Took $(($(date +%s) - started)) s"
printf '%d passed, %d failed, %d skipped\n' "$passed" "$failed" "$skipped"
[ "$failed" = 0 ] && [ "$passed" != 0 ]
