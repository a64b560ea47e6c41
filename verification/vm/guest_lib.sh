# Functions for the checks, which begin with `. /lib.sh`. A command that fails ends the check.
set -e

PROBE=/build/product/verification/vm/live_probe

# vcan NAME...: virtual CAN interfaces, up.
vcan()
{
    for name in "$@"; do
        ip link add dev "$name" type vcan
        ip link set "$name" up
    done
}

# cards: the two emulated Kvaser cards (SJA1000) can0 and can1 on one bus, 500 kbit/s, up.
cards()
{
    for name in can0 can1; do
        ip link set "$name" down
        ip link set "$name" type can bitrate 500000 restart-ms 0
        ip link set "$name" up
    done
}

# card_out NAME: takes the card of an interface out of the PCI bus. cards_in: what the bus has is there again.
card_out()
{
    echo 1 >"/sys/class/net/$1/device/remove"
}

cards_in()
{
    echo 1 >/sys/bus/pci/rescan
}

# ip: iproute2's; BusyBox's own knows no CAN.
ip()
{
    /tools/ip "$@"
}

# started PROGRAM: starts it in the background and sets `made` to the interface that it makes.
started()
{
    before=" $(ls /sys/class/net | tr '\n' ' ') "
    python3 "$1" >/tmp/adapter.log 2>&1 &
    echo $! >"/tmp/$!.pid"
    for _ in $(seq 100); do
        for link in $(ls /sys/class/net); do
            case $before in
                *" $link "*) ;;
                *)
                    made=$link
                    return 0
                    ;;
            esac
        done
        sleep 0.1
    done
    echo "no interface of $1 after 10 s"
    cat /tmp/adapter.log
    return 1
}

# adapter: the emulated USB CAN adapter (driver usb_8dev) usbcan0, up at 500 kbit/s. It obeys `adapter_says WORD`: see
# /guest_usb_adapter.py. Once connected it stays so for all checks: this driver frees its memory too early when its adapter
# is pulled out, and the kernel dies of it some time later.
adapter()
{
    if [ ! -e /tmp/adapter.connected ]; then
        started /guest_usb_adapter.py
        mv "/tmp/$!.pid" /tmp/adapter.connected
        sleep 0.3
        ip link set "$made" name usbcan0
    fi
    adapter_says release
    ip link set usbcan0 txqueuelen 10
    ip link set usbcan0 type can bitrate 500000 restart-ms 0
    ip link set usbcan0 up
}

# eventually COMMAND...: repeats it until it succeeds, at most five seconds.
eventually()
{
    for _ in $(seq 50); do
        ! "$@" || return 0
        sleep 0.1
    done
    echo "five seconds long not: $*"
    return 1
}

# shows NAME WORDS: `ip -details link show NAME` contains them.
shows()
{
    ip -details link show "$1" | grep -q -- "$2"
}

# serial_adapter [NAME]: the same by a serial line (driver slcan), named slcan0 by default. `serial_adapter_says WORD`.
serial_adapter()
{
    started /guest_serial_adapter.py
    ip link set "$made" name "${1:-slcan0}"
    ip link set "${1:-slcan0}" type can bitrate 500000
    ip link set "${1:-slcan0}" up
}

# ordered FILE WORD...: hands an order over and waits until it is taken.
ordered()
{
    file=$1
    shift
    echo "$*" >"$file.new"
    mv "$file.new" "$file"
    for _ in $(seq 100); do
        [ -e "$file" ] || return 0
        sleep 0.05
    done
    echo "the order '$*' was not taken within 5 s"
    return 1
}

# adapter_says WORD: busoff, active, warning, passive, hold, release, frame ID HEX, unplug
adapter_says()
{
    ordered /tmp/adapter.orders "$@"
}

serial_adapter_says()
{
    ordered /tmp/serial.orders "$@"
}

# clean_up: interfaces of checks, and the programs that they left.
clean_up()
{
    set +e
    for pid in $(cat /tmp/*.pid 2>/dev/null); do
        kill "$pid" 2>/dev/null
    done
    rm -f /tmp/*.pid /tmp/*.orders
    killall live_probe counterpoint 2>/dev/null
    for link in $(ls /sys/class/net); do
        case $link in
            vcan* | vxcan*) ip link del "$link" ;;
            can* | usbcan*) ip link set "$link" down ;;
        esac
    done
}
