# Two processes exchange 200 frames over two SJA1000 controllers on one bus
# Needs: build/product/verification/vm/live_probe
# Requirements: SRS_LIVE_020 SRS_LIVE_025
. /lib.sh
cards
$PROBE exchange can0 can1
