# python-can's socketcand client reaches vcan0 through counterpoint bus, both ways
# Needs: build/product/tools/counterpoint
# Requirements: SRS_LIVE_053
import subprocess
import sys
import time

import can

subprocess.run(["/tools/ip", "link", "add", "dev", "vcan0", "type", "vcan"], check=True)
subprocess.run(["/tools/ip", "link", "set", "vcan0", "up"], check=True)
server = subprocess.Popen(["/build/product/tools/counterpoint", "bus", "can0=vcan0", "--listen", "127.0.0.1:29536"],
                          stdout=subprocess.PIPE, text=True)
print(server.stdout.readline().strip())
remote = can.Bus(interface="socketcand", channel="can0", host="127.0.0.1", port=29536)
local = can.Bus(interface="socketcan", channel="vcan0")


def carry(sender, receiver, **fields):
    """One frame from one bus to the other, the same there, and the client's stamp is the wall clock."""
    sent = can.Message(**fields)
    sender.send(sent)
    got = receiver.recv(10)
    assert got is not None, f"nothing came of {sent}"
    assert (got.arbitration_id, got.is_extended_id, bytes(got.data)) == \
        (sent.arbitration_id, sent.is_extended_id, bytes(sent.data)), f"{sent} came as {got}"
    assert abs(got.timestamp - time.time()) < 12, f"stamp {got.timestamp}, now {time.time()}"


for number in range(50):
    data = bytes([number, 255 - number] * (number % 5))[:8]
    extended = number % 2 == 1
    identifier = 0x1ABC0000 + number if extended else 0x600 + number
    carry(remote, local, arbitration_id=identifier, data=data, is_extended_id=extended)
    carry(local, remote, arbitration_id=identifier, data=data, is_extended_id=extended)
remote.shutdown()
local.shutdown()
server.terminate()
assert server.wait(20) == 0, "counterpoint bus ends with 0 when asked to"
counts = server.stdout.read().strip()
print("note:", counts)
sys.exit(0 if counts.startswith("1 clients, 50 frames to the bus, 50 told to clients, 0 malformed") else 1)
