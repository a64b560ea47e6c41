# A client of other origin (python-canopen) reads, commands and may not change a running manager by its objects, on vcan0
# Needs: build/product/tools/counterpoint examples/emergency_stop/actuator.dcf tests/runtime/data/plain_slave.dcf
# Needs: tests/runtime/clients/manager_client.py tests/runtime/clients/manager_slave.py tests/runtime/clients/node_bus.py
# Requirements: SRS_MGR_020 SRS_MGR_021
# Seconds: 240
. /lib.sh
vcan vcan0
python3 /tests/runtime/clients/manager_client.py --can vcan0 --dcf /tests/runtime/data/plain_slave.dcf \
    --safety-dcf /examples/emergency_stop/actuator.dcf --program /build/product/tools/counterpoint --patience 4
