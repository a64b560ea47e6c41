# The interface goes down and up while the bus is open
# Needs: build/product/verification/vm/live_probe
# Requirements: SRS_LIVE_024
. /lib.sh
vcan vcan0
$PROBE down-and-up vcan0
