# The kernel's own restart (restart-ms) is recognised
# Needs: build/product/verification/vm/live_probe
# Requirements: SRS_LIVE_022
. /lib.sh
adapter
ip link set usbcan0 down
ip link set usbcan0 type can restart-ms 200
ip link set usbcan0 up
$PROBE kernel-restart usbcan0
