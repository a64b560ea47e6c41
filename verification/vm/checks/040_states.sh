# Error warning and passive of a real driver, frames from the bus meanwhile
# Needs: build/product/verification/vm/live_probe
# Requirements: SRS_LIVE_021
. /lib.sh
adapter
$PROBE states usbcan0
