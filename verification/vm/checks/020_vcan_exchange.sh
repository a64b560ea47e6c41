# Two processes exchange 200 frames over vcan0, confirmed and with the kernel's stamps in order
# Needs: build/product/verification/vm/live_probe
# Requirements: SRS_LIVE_002 SRS_LIVE_003 SRS_LIVE_020
. /lib.sh
vcan vcan0
$PROBE exchange vcan0 socketcan:vcan0
