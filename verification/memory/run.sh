#!/usr/bin/env bash
# ./dev sanitize: errors at run time that a test alone does not see. `./dev sanitize --help` tells what it runs.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
export BUILD=build/sanitize
# The tests of the certified part, its hardware layers and what both channels share.
QUICK=(tests/safety_core tests/channel_a tests/channel_b tests/hal verification/conformance)

# build_targets TARGET...
build_targets()
{
    echo "Building $BUILD ..."
    cmake --preset sanitize >build/log/sanitize-configure.log || { tail -n 40 build/log/sanitize-configure.log; return 1; }
    cmake --build "$BUILD" --parallel 2 --target "$@" >build/log/sanitize-build.log || { tail -n 40 build/log/sanitize-build.log; return 1; }
}

quick()
{
    build_targets "${QUICK[@]/%//all}"
    local folder
    for folder in "${QUICK[@]}"; do
        echo "Tests of $folder:"
        ctest --test-dir "$BUILD/$folder" --parallel 2 --timeout 1800 --output-on-failure >build/log/sanitize-quick.log ||
            { cat build/log/sanitize-quick.log; return 1; }
        grep 'tests passed\|No tests were found' build/log/sanitize-quick.log
    done
}

tests()
{
    build_targets all
    ctest --test-dir "$BUILD" --parallel 2 --timeout 1800 --output-on-failure --no-tests=error
}

# Arbitrary bytes end in an answer or in one precise error; a minute for each reader of foreign bytes, two at a time.
FUZZERS=(fuzz_dcf fuzz_sdo fuzz_log fuzz_socketcand)
fuzz_one()
{
    local name=$1 program seeds
    program=$(find "$BUILD" -name "$name" -type f -executable | head -n 1)
    [ -n "$program" ] || { echo "no program $name in $BUILD"; return 1; }
    seeds=build/fuzz/$name
    mkdir -p "$seeds"
    case $name in
        fuzz_dcf) find examples tests -name '*.dcf' -exec cp {} "$seeds" \; ;;
        fuzz_log) cp tests/canopen/monitor/fuzz_seeds/* "$seeds" ;;
        *) find tests -type d -name "${name}_seeds" -exec cp -r {}/. "$seeds" \; ;;
    esac
    if "$program" -max_total_time=60 -seed=1 -max_len=16384 -artifact_prefix="build/fuzz/$name-" "$seeds" \
        >"build/log/$name.log" 2>&1; then
        echo "$name: $(grep -h 'Done' "build/log/$name.log")"
    else
        echo "$name: FAILED"
        tail -n 60 "build/log/$name.log"
        return 255
    fi
}

fuzz()
{
    build_targets "${FUZZERS[@]}"
    export -f fuzz_one
    printf '%s\n' "${FUZZERS[@]}" | xargs -P 2 -I {} bash -c 'fuzz_one {}'
}

# Uninitialised and stray reads in the kernel's and the channels' own tests, in the objects that ship: each program in two
# halves, two at a time. Of the tests that flip every bit of a channel's storage in each phase of its work, which are most of
# the time, four phases of fourteen; ./dev test has all of them.
VALGRIND_FILTER=-$(printf 'Phases/*/%s:' 1 2 3 4 6 7 8 9 11 12)
valgrind_tests()
{
    local program programs=()
    while IFS= read -r program; do
        if grep -qa gtest_output "$program"; then
            programs+=("$program")
        fi
    done < <(find build/product/tests/safety_core build/product/tests/channel_a build/product/tests/channel_b \
        -maxdepth 2 -type f -executable 2>/dev/null | sort)
    [ "${#programs[@]}" -gt 0 ] || { echo "no test program of the kernel in build/product/tests, expected them after ./dev test"; return 1; }
    printf '%s\n' "${programs[@]}" | sed 's/$/ 0/;p;s/ 0$/ 1/' | FILTER=$VALGRIND_FILTER xargs -P 2 -L 1 bash -c '
        log=build/log/valgrind-$(basename "$0")-$1.log
        if GTEST_TOTAL_SHARDS=2 GTEST_SHARD_INDEX=$1 valgrind --quiet --error-exitcode=1 --track-origins=yes \
            "$0" --gtest_brief=1 --gtest_filter="$FILTER" </dev/null >"$log" 2>&1; then
            echo "valgrind: $0, half $(($1 + 1)) of 2: passed"
        else
            echo "valgrind: $0, half $(($1 + 1)) of 2: FAILED"
            tail -n 40 "$log"
            exit 255
        fi'
}

mkdir -p build/log
[ $# -le 1 ] || { echo "sanitize: unknown argument '$2', expected one at most" >&2; exit 2; }
case ${1:-all} in
    --quick) quick ;;
    tests) tests ;;
    valgrind) valgrind_tests ;;
    fuzz) fuzz ;;
    all)
        tests
        valgrind_tests
        fuzz
        ;;
    *)
        echo "sanitize: unknown argument '$1', expected --quick, tests, valgrind, fuzz or nothing" >&2
        exit 2
        ;;
esac
