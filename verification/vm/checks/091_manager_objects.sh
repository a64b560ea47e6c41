# A client of other origin (python-canopen) reads, commands and may not change a running manager by its objects, on vcan0
# Needs: build/product/tools/counterpoint examples/emergency_stop/actuator.dcf tests/tools/data/plain_slave.dcf
# Needs: tests/tools/manager_client.py tests/tools/manager_slave.py tests/tools/node_bus.py
# Requirements: SRS-MGR-020 SRS-MGR-021
# Seconds: 240
. /lib.sh
vcan vcan0
python3 /tests/tools/manager_client.py --can vcan0 --dcf /tests/tools/data/plain_slave.dcf \
    --safety-dcf /examples/emergency_stop/actuator.dcf --program /build/product/tools/counterpoint --patience 4
