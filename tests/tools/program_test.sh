#!/bin/sh
# program_test.sh PROGRAM SOURCE_FOLDER: the program's exit status on what must not hang or crash it.
program=$1
source=$2
folder=$(mktemp -d) || exit 2
trap 'rm -rf "$folder"' EXIT
failures=0

# expect STATUS ARGS...: an end, this exit status, and exactly one line on the error output when it is 2.
expect() {
  status=$1
  shift
  timeout 300 "$program" "$@" >"$folder/out" 2>"$folder/err" </dev/null
  actual=$?
  lines=$(wc -l <"$folder/err")
  if [ "$actual" -ne "$status" ] || { [ "$status" -eq 2 ] && [ "$lines" -ne 1 ]; }; then
    echo "counterpoint $*: status $actual, expected $status; $lines error lines"
    cat "$folder/err"
    failures=$((failures + 1))
  fi
}

mkfifo "$folder/pipe"
truncate -s 100M "$folder/large.dcf"
head -c 20000 "$program" >"$folder/binary.dcf"
: >"$folder/empty.dcf"
for command in sign check; do
  expect 0 "$command" "$source/examples/emergency_stop/sensor.dcf"
  expect 2 "$command" "$folder/pipe"
  expect 2 "$command" /dev/zero
  expect 2 "$command" /dev/null
  expect 2 "$command" "$folder"
  expect 2 "$command" "$folder/large.dcf"
  expect 2 "$command" "$folder/binary.dcf"
  expect 2 "$command" "$folder/empty.dcf"
  expect 2 "$command" "$folder/missing.dcf"
done
expect 2 sign "$source/examples/emergency_stop/sensor.dcf" --write "$folder"
expect 2
expect 0 --help
# Without a terminal nothing is asked; at one the answers are taken.
expect 2 new -o "$folder/new.dcf" --produce 8
expect 0 new -o "$folder/new.dcf" --node-id 5 --produce 8
expect 2 new -o "$folder/new.dcf" --node-id 5 --produce 8
expect 0 srdo list "$folder/new.dcf"
expect 2 srdo list "$folder/missing.dcf"
# (script runs the program at a terminal of its own; the answers stand ready, Enter takes a default.)
printf 'producer\n7\n\n2x8\n\n\n\n\n\n\n\n\n' >"$folder/answers"
timeout 300 script --quiet --return --command "'$program' new -o '$folder/asked.dcf'" /dev/null <"$folder/answers" >"$folder/out" 2>&1
if [ $? -ne 0 ]; then
  echo "counterpoint new at a terminal: expected status 0"
  cat "$folder/out"
  failures=$((failures + 1))
fi
expect 0 check "$folder/asked.dcf"
# An answer that cannot be written is no answer.
timeout 300 "$program" sign "$source/examples/emergency_stop/sensor.dcf" >/dev/full 2>/dev/null
if [ $? -ne 2 ]; then
  echo "counterpoint sign >/dev/full: expected status 2"
  failures=$((failures + 1))
fi
# Nobody reads what a command tells: SIGTERM ends it all the same, within two seconds and what a busy machine takes.
mkfifo "$folder/unread"
exec 3<>"$folder/unread"
head -c 65536 /dev/zero >&3
bus=udp:239.74.163.94:$((20000 + $$ % 40000))
ends_unread() {
  timeout --kill-after=30 1 "$program" "$@" >&3 2>"$folder/err" </dev/null
  actual=$?
  if [ "$actual" -ne 124 ]; then
    echo "counterpoint $* >unread: status $actual, expected an end by SIGTERM"
    cat "$folder/err"
    failures=$((failures + 1))
  fi
}
ends_unread monitor --can "$bus" --frames --for 600
ends_unread monitor --can "$bus" --frames --for 600 --json
ends_unread bus "$bus" --listen 127.0.0.1:0
ends_unread node --can "$bus" --dcf "$source/examples/emergency_stop/sensor.dcf" --no-input
ends_unread manager --can "$bus" --network "$source/examples/networks/chain.yaml" --no-input
ends_unread simulate "$source/examples/networks/boot.yaml"
exec 3>&-
[ "$failures" -eq 0 ]
