# Two processes exchange 200 frames over vcan0, confirmed and with the kernel's stamps in order
# Needs: build/product/verification/vm/live_probe
# Requirements: SRS-LIVE-002 SRS-LIVE-003 SRS-LIVE-020
. /lib.sh
vcan vcan0
$PROBE exchange vcan0 socketcan:vcan0
