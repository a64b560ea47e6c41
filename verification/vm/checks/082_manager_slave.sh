# The network manager boots, refuses, loses and restarts a slave of other origin (python-canopen) on vcan0
# Needs: build/product/tools/counterpoint tests/runtime/data/plain_slave.dcf tests/runtime/clients/manager_slave.py tests/runtime/clients/node_bus.py
# Requirements: SRS_MGR_013
# Seconds: 240
. /lib.sh
vcan vcan0
python3 /tests/runtime/clients/manager_slave.py --can vcan0 --dcf /tests/runtime/data/plain_slave.dcf \
    --program /build/product/tools/counterpoint
