# A CAN card is taken out of the PCI bus and put in again
# Needs: build/product/verification/vm/live_probe
# Requirements: SRS_LIVE_024
. /lib.sh
cards
$PROBE unplugged can1
