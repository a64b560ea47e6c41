#!/bin/busybox sh
# First process of the virtual machine: loads the modules, runs the checks one after the other, reports to the second
# serial line, switches off.
/bin/busybox --install -s /bin
export PATH=/tools:/python/bin:/bin PYTHONHOME=/python PYTHONPATH=/python/packages PYTHONDONTWRITEBYTECODE=1 HOME=/tmp
mount -t proc none /proc
mount -t sysfs none /sys
mount -t devtmpfs none /dev
mkdir -p /dev/pts /dev/shm
mount -t devpts none /dev/pts
mount -t tmpfs none /dev/shm
exec 3>/dev/ttyS1
ip link set lo up
while read -r module; do
    insmod "/modules/$module" || echo "  module $module cannot be loaded" >&3
done </modules/order
echo up >&3
while read -r check seconds; do
    begin=$(date +%s)
    case $check in
        *.py) program="python3" ;;
        *) program="sh" ;;
    esac
    timeout -k 2 "$seconds" $program "/checks/$check" </dev/null >/tmp/output 2>&1
    status=$?
    took=$(($(date +%s) - begin))
    if [ $status -eq 0 ]; then
        grep '^note: ' /tmp/output | sed 's/^note: /  /' >&3
        echo "pass $check $took" >&3
    else
        # What it said, then the verdict.
        tail -n 200 /tmp/output | sed 's/^/! /' >&3
        [ $status -ne 143 ] && [ $status -ne 124 ] || echo "! no end after $seconds s" >&3
        dmesg | tail -n 20 | sed 's/^/! kernel: /' >&3
        echo "FAIL $check $took" >&3
    fi
    # What a check left behind must not disturb the next one.
    sh -c '. /lib.sh; clean_up' >/dev/null 2>&1
done </checks/plan
echo end >&3
sleep 0.2
poweroff -f
