# The network manager boots, refuses, loses and restarts a slave of other origin (python-canopen) on vcan0
# Needs: build/product/tools/counterpoint tests/tools/data/plain_slave.dcf tests/tools/manager_slave.py tests/tools/node_bus.py
# Requirements: SRS-MGR-013
# Seconds: 240
. /lib.sh
vcan vcan0
python3 /tests/tools/manager_slave.py --can vcan0 --dcf /tests/tools/data/plain_slave.dcf \
    --program /build/product/tools/counterpoint --patience 4
