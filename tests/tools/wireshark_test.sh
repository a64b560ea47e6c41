#!/bin/sh
# wireshark_test.sh SOURCE_FOLDER: what tshark shows of SRDO and GFC with the dissector of tools/wireshark. [SRS_MON_015,
# SRS_MON_045, SRS_MON_170]
source=$1
if ! command -v tshark >/dev/null; then
  echo "tshark is not installed: left out (Debian package tshark)"
  exit 77
fi
folder=$(mktemp -d) || exit 2
trap 'rm -rf "$folder"' EXIT
dissector=$source/tools/wireshark/counterpoint_srdo.lua
failures=0

# show ARGS...: what tshark prints; no settings or plugins of the person who runs the test.
show() {
  HOME=$folder XDG_CONFIG_HOME=$folder tshark -X lua_script:"$dissector" "$@" 2>"$folder/err"
}

# expect NAME EXPECTED: the text on the standard input is the expected file.
expect() {
  if ! diff -u "$2" "$folder/found" >"$folder/difference"; then
    echo "$1: expected and found differ"
    cat "$folder/difference" "$folder/err"
    failures=$((failures + 1))
  fi
}

# Times of today: they have to keep their microseconds.
cat >"$folder/planted.log" <<'TEXT'
(1700000001.000000) can0 101#0102
(1700000001.000200) can0 102#FEFD
(1700000001.025000) can0 101#0102
(1700000001.045000) can0 102#FEFD
(1700000001.050000) can0 101#0102
(1700000001.070001) can0 102#FEFD
(1700000001.075000) can0 101#0102
(1700000001.075200) can0 102#FEFC
(1700000001.100200) can0 102#FEFD
(1700000001.125000) can0 101#0102
(1700000001.125100) can0 101#0102
(1700000001.125200) can0 102#FEFD
(1700000001.150000) can0 101#0102
(1700000001.150200) can0 102#FE
(1700000001.175000) can0 101#0102
(1700000001.200000) can0 101#0102
(1700000001.200200) can0 102#FEFD
(1700000001.250001) can0 101#0102
(1700000001.250200) can0 102#FEFD
(1700000001.300300) can0 001#
(1700000001.300400) can0 001#00
(1700000001.300600) can0 101#R
(1700000001.300700) can0 00000101#01
(1700000001.300800) can0 101##0112233
(1700000001.300900) can0 17F#01
(1700000001.301000) can0 180#FE
(1700000001.301100) can0 181#FE
(1700000001.301200) can0 001#R
(1700000001.301300) can0 001##0
(1700000001.400000) can0 103#01
(1700000001.399000) can0 104#FE
TEXT
cat >"$folder/expected" <<'TEXT'
1 SRDO 101h normal
2 SRDO 102h inverse of frame 1, 0.200 ms
3 SRDO 101h normal
4 SRDO 102h inverse of frame 3, 20.000 ms
5 SRDO 101h normal
6 SRDO 102h inverse of frame 5, 20.001 ms [SRVT: 20.001 ms after the normal frame, limit 20 ms]
7 SRDO 101h normal
8 SRDO 102h inverse of frame 7, 0.200 ms [not inverse]
9 SRDO 102h inverse [inverse first: no normal frame before it]
10 SRDO 101h normal
11 SRDO 101h normal [normal twice: no inverse frame since frame 10]
12 SRDO 102h inverse
13 SRDO 101h normal
14 SRDO 102h inverse of frame 13, 0.200 ms [length: 1 bytes, the normal frame has 2]
15 SRDO 101h normal
16 SRDO 101h normal [SRVT: no inverse frame within 20 ms after frame 15]
17 SRDO 102h inverse of frame 16, 0.200 ms
18 SRDO 101h normal [SCT: 50.001 ms since the last valid pair, limit 50 ms]
19 SRDO 102h inverse of frame 18, 0.199 ms
20 Global fail-safe command
22 SRDO 101h normal [remote frame: nobody counts it]
25 SRDO 17Fh normal
26 SRDO 180h inverse of frame 25, 0.100 ms
30 SRDO 103h normal
31 SRDO 104h inverse of frame 30, -1.000 ms [its time is before that of the normal frame]
TEXT
show -o srdo.sct:50 -r "$folder/planted.log" -Y "srdo or gfc" -T fields -E separator=/s -e frame.number -e _ws.col.Info >"$folder/found"
expect "Information column" "$folder/expected"

# Each violation is an expert information; limits of single pairs, and none.
echo "6 8 9 11 14 16 18 22 31" >"$folder/expected"
show -o srdo.pairs:"101:50/20" -r "$folder/planted.log" -Y "srdo.expert" -T fields -e frame.number | tr '\n' ' ' | sed 's/ $/\n/' >"$folder/found"
expect "Expert information" "$folder/expected"
echo "8 9 11 14 16 22 31" >"$folder/expected"
show -o srdo.srvt:0 -r "$folder/planted.log" -Y "srdo.expert" -T fields -e frame.number | tr '\n' ' ' | sed 's/ $/\n/' >"$folder/found"
expect "No limits" "$folder/expected"

# A capture may begin within a pair: no longer than SRVT, and once. SCT is over whatever frame comes behind it.
cat >"$folder/begun.log" <<'TEXT'
(1700000001.000000) can0 080#
(1700000001.020000) can0 102#FEFD
(1700000001.020001) can0 104#FEFD
(1700000001.020002) can0 102#FEFD
(1700000001.025000) can0 101#0102
(1700000001.025200) can0 102#FEFD
(1700000001.075001) can0 102#FEFD
TEXT
cat >"$folder/expected" <<'TEXT'
2 SRDO 102h inverse
3 SRDO 104h inverse [inverse first: no normal frame before it]
4 SRDO 102h inverse [inverse first: no normal frame before it]
5 SRDO 101h normal
6 SRDO 102h inverse of frame 5, 0.200 ms
7 SRDO 102h inverse [SCT: 50.001 ms since the last valid pair, limit 50 ms] [inverse first: no normal frame before it]
TEXT
show -o srdo.sct:50 -r "$folder/begun.log" -Y "srdo" -T fields -E separator=/s -e frame.number -e _ws.col.Info >"$folder/found"
expect "Begin within a pair" "$folder/expected"

# The fields of a pair, of a capture in pcapng; in the second pass the normal frame knows its inverse.
show -2 -r "$source/tests/canopen/monitor/fuzz_seeds/chain.pcapng" -Y "frame.number < 3" -T fields -E separator=/s \
  -e frame.number -e srdo.number -e srdo.half -e srdo.partner -e srdo.inverted -e srdo.valid -e srdo.srvt_ms >"$folder/found"
sed -i 's/True/1/g; s/False/0/g' "$folder/found"
printf '1 1 0 2  1 \n2 1 1 1 1 1 0.136\n' >"$folder/expected"
expect "Fields of a pair" "$folder/expected"

# Pairs of one interface have nothing to do with those of another, in a capture of all (SLL2): each frame by its microsecond,
# the index of its interface, the low byte of its identifier and its data, all octal.
cooked() {
  printf "\\001\\000\\000\\000\\$1\\000\\000\\000\\044\\000\\000\\000\\044\\000\\000\\000"
  printf "\\000\\014\\000\\000\\000\\000\\000\\$2\\001\\030\\001\\000\\000\\000\\000\\000\\000\\000\\000\\000"
  printf "\\$3\\001\\000\\000\\001\\000\\000\\000\\$4\\000\\000\\000\\000\\000\\000\\000"
}
{
  printf '\324\303\262\241\002\000\004\000\000\000\000\000\000\000\000\000\000\000\004\000\024\001\000\000'
  cooked 000 003 001 001
  cooked 144 004 001 002
  cooked 310 003 002 376
  cooked 372 004 002 376
} >"$folder/two.pcap"
cat >"$folder/expected" <<'TEXT'
1 SRDO 101h normal
2 SRDO 101h normal
3 SRDO 102h inverse of frame 1, 0.200 ms
4 SRDO 102h inverse of frame 2, 0.150 ms [not inverse]
TEXT
show -r "$folder/two.pcap" -T fields -E separator=/s -e frame.number -e _ws.col.Info >"$folder/found"
expect "Two interfaces" "$folder/expected"

# A clean recording of the simulator has no violation, and CANopen keeps its own frames.
: >"$folder/expected"
show -o srdo.sct:50 -r "$source/tests/canopen/monitor/fuzz_seeds/chain.log" -Y "srdo.expert" >"$folder/found"
expect "Clean recording" "$folder/expected"
echo "CANopen SRDO CANopen" >"$folder/expected"
printf '(1.000000) can0 701#05\n(1.000001) can0 101#01\n(1.000002) can0 601#4017100000000000\n' >"$folder/mixed.log"
show -d can.subdissector,canopen -r "$folder/mixed.log" -T fields -e _ws.col.Protocol | tr '\n' ' ' | sed 's/ $/\n/' >"$folder/found"
expect "Other dissectors" "$folder/expected"

[ "$failures" -eq 0 ]
