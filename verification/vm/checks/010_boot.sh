# The modules are loaded, two SJA1000 cards are there, Python imports canopen
# Requirements: SRS_LIVE_040
. /lib.sh
for module in vcan can_raw can_gw kvaser_pci sja1000 usb_8dev vhci_hcd; do
    [ -d "/sys/module/$module" ] || { echo "module $module is not loaded"; exit 1; }
done
cards
ip -details link show can0 | grep -q "state ERROR-ACTIVE"
ip -details link show can1 | grep -q "sja1000"
python3 -c "import canopen, can; print('canopen', canopen.__version__)"
