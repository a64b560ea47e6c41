# Linux's driver takes the emulated USB adapter: state, bus-off and restart are the kernel's own
. /lib.sh
adapter
shows usbcan0 "state ERROR-ACTIVE"
adapter_says busoff
eventually shows usbcan0 "state BUS-OFF"
eventually shows usbcan0 "NO-CARRIER"
ip link set usbcan0 type can restart
eventually shows usbcan0 "state ERROR-ACTIVE"
