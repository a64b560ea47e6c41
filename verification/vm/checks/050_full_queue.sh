# A full send queue loses no frame and no order; nothing is confirmed before it is sent
# Needs: build/product/verification/vm/live_probe
# Requirements: SRS_LIVE_004 SRS_LIVE_023 SRS_LIVE_025
. /lib.sh
adapter
$PROBE full-queue usbcan0
