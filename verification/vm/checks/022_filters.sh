# The kernel passes only what matches the filters
# Needs: build/product/verification/vm/live_probe
# Requirements: SRS_LIVE_014
. /lib.sh
vcan vcan0
$PROBE filters vcan0
