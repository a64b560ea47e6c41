# A full send queue loses no frame and no order; nothing is confirmed before it is sent
# Needs: build/product/verification/vm/live_probe
# Requirements: SRS-LIVE-004 SRS-LIVE-023 SRS-LIVE-025
. /lib.sh
adapter
$PROBE full-queue usbcan0
