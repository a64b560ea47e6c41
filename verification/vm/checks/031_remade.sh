# The interface is removed and made again under its name
# Needs: build/product/verification/vm/live_probe
# Requirements: SRS_LIVE_024
. /lib.sh
vcan vcan0
$PROBE remade vcan0
