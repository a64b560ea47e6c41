# The manager as an EL6751 boots, loses and refuses a slave of other origin (python-canopen) beside a safety slave
# Needs: build/product/tools/counterpoint examples/emergency_stop/actuator.dcf tests/tools/data/third_party_slave.dcf
# Needs: tests/tools/third_party_network.py tests/tools/third_party_slave.py tests/tools/node_bus.py
# Requirements: SRS-MGR-014
# Seconds: 300
. /lib.sh
vcan vcan0
python3 /tests/tools/third_party_network.py --can vcan0 --dcf /tests/tools/data/third_party_slave.dcf \
    --safety-dcf /examples/emergency_stop/actuator.dcf --program /build/product/tools/counterpoint --profile el6751 \
    --cycle-us 50000 --patience 4
