# Bus-off of a driver without a restart ends by taking the interface down and up
# Needs: build/product/verification/vm/live_probe
# Requirements: SRS_LIVE_022
. /lib.sh
serial_adapter slcan0
$PROBE restart-by-switch slcan0
