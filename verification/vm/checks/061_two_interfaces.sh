# Plain and inverse frames by separate SJA1000 controllers, stamps in bus order over both
# Needs: build/product/verification/vm/live_probe
# Requirements: SRS_LIVE_026
. /lib.sh
cards
$PROBE two-interfaces can0 can1
