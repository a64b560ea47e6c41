#!/bin/sh
# program_test.sh PROGRAM SOURCE_FOLDER BUILD_FOLDER: the program's exit status on what must not hang or crash it.
program=$1
source=$2
build=$3
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
# ends_unread STATUS ARGS...: this exit status, and no end before SIGTERM comes (twice, as timeout sends it). [SRS_MON_001, SRS_MGR_004, SRS_LIVE_056]
ends_unread() {
  status=$1
  shift
  "$program" "$@" >&3 2>"$folder/err" </dev/null &
  pid=$!
  # It has begun when it catches SIGTERM; what never does is ended by the system.
  while [ "$status" -ne 143 ] && lives && ! grep -Eq '^SigCgt:.*[4-7c-f][0-9a-f]{3}$' "/proc/$pid/status" 2>"$folder/out"; do
    sleep 0.1
  done
  sleep 1
  told="before SIGTERM"
  if lives; then
    told="after SIGTERM"
    kill -TERM "$pid"
    sleep 0.5
    kill -TERM "$pid" 2>"$folder/out"
    steps=300
    while lives && [ "$steps" -gt 0 ]; do
      sleep 0.1
      steps=$((steps - 1))
    done
    kill -KILL "$pid" 2>"$folder/out"
  fi
  wait "$pid" 2>"$folder/out"
  actual=$?
  if [ "$actual" -ne "$status" ] || [ "$told" != "after SIGTERM" ]; then
    echo "counterpoint $* >unread: status $actual $told, expected $status after it"
    cat "$folder/err"
    failures=$((failures + 1))
  fi
}
lives() {
  [ -e "/proc/$pid/status" ] && ! grep -q '^State:.*Z' "/proc/$pid/status" 2>"$folder/out"
}
# That case sees a wrong end: another status after the signal, and the right one before it.
for wrong in "trap 'exit 3' TERM; while :; do sleep 0.1; done" "exit 2"; do
  printf '#!/bin/sh\n%s\n' "$wrong" >"$folder/wrong"
  chmod +x "$folder/wrong"
  right=$program
  program=$folder/wrong
  before=$failures
  ends_unread 2 "$wrong" >"$folder/seen"
  program=$right
  if [ "$failures" -ne $((before + 1)) ]; then
    echo "ends_unread takes '$wrong' for a program that ends with status 2 after SIGTERM"
    failures=$((failures + 1))
  fi
  failures=$((failures - 1))
done
ends_unread 2 monitor --can "$bus" --frames --for 600
ends_unread 2 monitor --can "$bus" --frames --for 600 --json
ends_unread 2 bus "$bus" --listen 127.0.0.1:0
ends_unread 2 node --can "$bus" --dcf "$source/examples/emergency_stop/sensor.dcf" --no-input
ends_unread 2 manager --can "$bus" --network "$source/examples/networks/chain.yaml" --no-input
ends_unread 143 simulate "$source/examples/networks/boot.yaml"
exec 3>&-
# The version tells the objects of core and channels that are in the build. [SRS_CLI_024]
digest() {
  for room in safety_core/comparator safety_core/kernel safety_core/selftest safety_core/crosslink hal/api channel_a channel_b; do
    objects=$folder/objects/$room
    mkdir -p "$objects"
    (cd "$objects" && ar x "$build/$room/lib$(echo "$room" | tr / _).a")
    (cd "$objects" && LC_ALL=C ls) | while read -r object; do
      echo "$room/$object:$(sha256sum <"$objects/$object" | cut -d ' ' -f 1)"
    done
  done | sha256sum | cut -c 1-16
}
if ! "$program" --version | grep -Eq "^counterpoint [0-9.]+ \(commit ([0-9a-f]{12}|unknown), objects $(digest)\)$"; then
  echo "counterpoint --version: '$("$program" --version)', expected objects $(digest)"
  failures=$((failures + 1))
fi
[ "$failures" -eq 0 ]
