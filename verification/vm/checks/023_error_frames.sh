# Error frames drive state, counters and counts
# Needs: build/product/verification/vm/live_probe
# Requirements: SRS_LIVE_021
. /lib.sh
vcan vcan0
$PROBE error-frames vcan0
