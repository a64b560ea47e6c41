# Frames that the kernel drops because nobody reads are counted
# Needs: build/product/verification/vm/live_probe
# Requirements: SRS_LIVE_027
. /lib.sh
vcan vcan0
$PROBE lost-frames vcan0
