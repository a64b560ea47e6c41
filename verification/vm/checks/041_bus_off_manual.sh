# Bus-off of a real driver stays until the restart is asked for
# Needs: build/product/verification/vm/live_probe
# Requirements: SRS_LIVE_022
. /lib.sh
adapter
$PROBE manual-restart usbcan0
