#!/usr/bin/env bash
# live.sh PROGRAM: runs a test program whose devices live in real time. On a machine that lets a program wait which wants
# to run, such a test says nothing about the devices. A probe wants to be woken every 10 ms: when it was woken more than
# 30 ms late while a run failed, the run is repeated, twice at the most. A failure on a machine in time is a failure.
set -u
late_file=$(mktemp)

# Writes the greatest delay in ms, until it is killed.
probe()
{
    local greatest=0 before=${EPOCHREALTIME/[.,]/} now delay
    while sleep 0.01; do
        now=${EPOCHREALTIME/[.,]/}
        delay=$(((now - before) / 1000 - 10))
        before=$now
        if [ "$delay" -gt "$greatest" ]; then
            greatest=$delay
            echo "$greatest" >"$late_file"
        fi
    done
}

for attempt in 1 2 3; do
    echo 0 >"$late_file"
    probe &
    prober=$!
    "$@"
    status=$?
    kill "$prober"
    wait "$prober" 2>/dev/null
    late=$(cat "$late_file")
    if [ "$status" -eq 0 ] || [ "$late" -le 30 ] || [ "$attempt" -eq 3 ]; then
        rm -f "$late_file"
        exit "$status"
    fi
    echo "live.sh: the machine was $late ms late; run $attempt failed and is repeated"
done
