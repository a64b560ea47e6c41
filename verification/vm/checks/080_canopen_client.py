# A CANopen client of other origin (canopen) on vcan0: SDO, NMT and heartbeat of a live device
# Needs: build/product/tools/counterpoint tests/tools/data/everything.dcf
# Seconds: 180
import subprocess
import sys
import time

import canopen

DCF = "/tests/tools/data/everything.dcf"
subprocess.run(["/tools/ip", "link", "add", "dev", "vcan0", "type", "vcan"], check=True)
subprocess.run(["/tools/ip", "link", "set", "vcan0", "up"], check=True)
device = subprocess.Popen(["/build/product/tools/counterpoint", "node", "--can", "vcan0", "--dcf", DCF, "--no-input",
                           "--cycle-us", "50000"], stdout=open("/tmp/node.log", "w", encoding="utf-8"))
try:
    network = canopen.Network()
    network.connect(interface="socketcan", channel="vcan0")
    dictionary = canopen.import_od(DCF)
    node = network.add_node(canopen.RemoteNode(dictionary.node_id or 1, dictionary))
    node.sdo.RESPONSE_TIMEOUT = 5.0
    for _ in range(20):
        if device.poll() is not None:
            sys.exit("the device ended by itself:\n" + open("/tmp/node.log", encoding="utf-8").read())
        try:
            kind = node.sdo[0x1000].raw
            break
        except canopen.SdoCommunicationError:
            time.sleep(0.5)
    else:
        sys.exit("no answer by SDO")
    assert kind == dictionary[0x1000].default, f"1000h is {kind:08X}h, in the file {dictionary[0x1000].default:08X}h"
    assert node.sdo[0x1018][1].raw == dictionary[0x1018][1].default
    node.sdo[0x1017].raw = 200
    assert node.sdo[0x1017].raw == 200
    try:
        node.sdo.upload(0x7ABC, 0)
        sys.exit("an object that is not there was read")
    except canopen.SdoAbortedError as error:
        assert error.code == 0x06020000, f"abort {error.code:08X}h"
    seen = []
    for order, state in (("PRE-OPERATIONAL", "PRE-OPERATIONAL"), ("STOPPED", "STOPPED"), ("PRE-OPERATIONAL", "PRE-OPERATIONAL")):
        node.nmt.state = order
        for _ in range(20):
            if node.nmt.wait_for_heartbeat(5) == state:
                break
        assert node.nmt.state == state, f"{node.nmt.state} after the order {order}"
        seen.append(state)
    print("note: device type, identity, heartbeat, abort code as in the DCF; states by heartbeat:", ", ".join(seen))
    network.disconnect()
finally:
    device.terminate()
