# A client of other origin reads the dictionaries of generated code on vcan0: shipped files, static mapping, random ones
# Needs: build/product/tests/canopen/generate/generated_node tests/canopen/generate/generated_client.py tests/runtime/clients/node_bus.py
# Needs: examples/sensor/sensor.dcf examples/emergency_stop/actuator.dcf tests/canopen/cia306/data/static.dcf
# Needs: build/product/tests/canopen/generate/generated/random_1.dcf build/product/tests/canopen/generate/generated/random_2.dcf
# Needs: build/product/tests/canopen/generate/generated/random_3.dcf build/product/tests/canopen/generate/generated/random_4.dcf
# Requirements: SRS_GEN_017
# Seconds: 300
. /lib.sh
vcan vcan0
python3 /tests/canopen/generate/generated_client.py --program /build/product/tests/canopen/generate/generated_node --can vcan0 \
    --root / --patience 5 sensor chain_actuator data_static random_1 random_2 random_3 random_4
