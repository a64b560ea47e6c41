# Bus-off of a real driver ends after 300 ms by policy
# Needs: build/product/verification/vm/live_probe
# Requirements: SRS_LIVE_022
. /lib.sh
adapter
$PROBE timed-restart usbcan0
