# Own frames are told from those of another socket of the same interface
# Needs: build/product/verification/vm/live_probe
# Requirements: SRS_LIVE_025
. /lib.sh
vcan vcan0
$PROBE own vcan0
