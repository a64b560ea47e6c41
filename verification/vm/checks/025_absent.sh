# What is no CAN interface cannot be opened, and a sentence says so
# Needs: build/product/verification/vm/live_probe
# Requirements: SRS_LIVE_020
. /lib.sh
$PROBE absent nocan9 lo
