# The manager as an EL6751 boots, loses and refuses a slave of other origin (python-canopen) beside a safety slave
# Needs: build/product/tools/counterpoint examples/emergency_stop/actuator.dcf tests/runtime/data/third_party_slave.dcf
# Needs: tests/runtime/clients/third_party_network.py tests/runtime/clients/third_party_slave.py tests/runtime/clients/node_bus.py
# Requirements: SRS_MGR_014
# Seconds: 300
. /lib.sh
vcan vcan0
python3 /tests/runtime/clients/third_party_network.py --can vcan0 --dcf /tests/runtime/data/third_party_slave.dcf \
    --safety-dcf /examples/emergency_stop/actuator.dcf --program /build/product/tools/counterpoint --profile el6751 \
    --cycle-us 50000 --patience 4
