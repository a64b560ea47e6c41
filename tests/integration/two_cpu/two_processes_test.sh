#!/bin/sh
# Two processes run as the two CPUs of a device: both release; when B goes away, A is safe within the limit.
# Usage: two_processes_test.sh RUN PROGRAM. RUN gives both one stepped time, whatever else the machine does. The ports are
# from a range that depends on this shell's number.
set -u
run=$1
program=$2
port=$((20000 + ($$ % 10000) * 4))

# expect_last LINE: of what was told.
expect_last()
{
    printf '%s\n' "$told"
    if [ "$(printf '%s\n' "$told" | tail -n 1)" != "$1" ]; then
        echo "two_processes_test: expected $1"
        exit 1
    fi
}

told=$("$run" "$program" --role b --port "$port" --seconds 4.5 -- "$program" --role a --port "$port" --seconds 7 --expect-loss)
expect_last "exit statuses: 0 0"

# A port that is taken is bad input: one line, status 2. Of a CPU without the other one nothing opens: status 1.
told=$("$run" "$program" --role a --port "$port" --seconds 3 -- "$program" --role a --port "$port" --seconds 3 2>&1)
case $told in
    *"expected a free port"*) ;;
    *) echo "two_processes_test: no reason for a taken port in: $told"; exit 1 ;;
esac
case $told in
    *"exit statuses: 1 2" | *"exit statuses: 2 1") ;;
    *) echo "two_processes_test: expected statuses 1 and 2 of two on one port in: $told"; exit 1 ;;
esac
