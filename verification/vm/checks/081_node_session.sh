# A client of other origin walks the whole dictionary of a live device on vcan0: transfers, NMT, partners, PDO, safety
# Needs: build/product/tools/counterpoint tests/runtime/data/everything.dcf tests/runtime/clients/node_client.py tests/runtime/clients/node_client_safety.py tests/runtime/clients/node_bus.py
# Requirements: SRS_NODE_010
# Seconds: 240
. /lib.sh
vcan vcan0
python3 /tests/runtime/clients/node_client.py --can vcan0 --dcf /tests/runtime/data/everything.dcf \
    --program /build/product/tools/counterpoint --cycle-us 50000 --patience 4
