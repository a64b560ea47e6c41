#!/usr/bin/env python3
"""A client of other origin (canopen, python-can) at the objects of a running `counterpoint manager`.

    manager_client.py --can ADDRESS --dcf FILE --safety-dcf FILE --program COUNTERPOINT [--patience N]

The network has a slave of python-canopen (10, its DCF), a safety slave that is not there (33, its DCF) and the manager
(127). The client reads the network of the manager and commands it by 1F82h; what must not be written is refused. One line
a check; exit status 0 only when all hold.
"""
import argparse
import pathlib
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import canopen  # noqa: E402
from manager_slave import NODE, Checks, Slave, eventually  # noqa: E402
from node_bus import open_bus  # noqa: E402

MANAGER, SAFETY, ALL = 127, 33, 0x80
STOP, START = b"\x04", b"\x05"


class Client:
    """SDO client of the manager, and everything that it sends."""

    def __init__(self, address):
        self.frames = []
        self.network = canopen.Network()
        self.network.bus = open_bus(address)
        self.network.listeners.append(
            lambda message: self.frames.append((message.arbitration_id, bytes(message.data))))
        self.network.connect()
        self.node = self.network.add_node(MANAGER, canopen.ObjectDictionary())
        self.node.sdo.RESPONSE_TIMEOUT = 5.0

    def read(self, index, sub=0):
        return self.node.sdo.upload(index, sub)

    def number(self, index, sub=0):
        return int.from_bytes(self.read(index, sub), "little")

    def write(self, index, sub, data):
        """0, or the abort code."""
        try:
            self.node.sdo.download(index, sub, data)
        except canopen.SdoAbortedError as error:
            return error.code
        return 0

    def count(self, identifier, data):
        return self.frames.count((identifier, data))

    def close(self):
        self.network.disconnect()


def look(checks, client, arguments):
    checks.check("the manager has sent its boot-up message", client.count(0x700 + MANAGER, b"\x00") >= 1)
    checks.check("and heartbeats",
                 eventually(lambda: client.count(0x700 + MANAGER, b"\x05") > 2))
    checks.check("1F80h is read", client.number(0x1F80) == 1, client.read(0x1F80))
    checks.check("1F81h has the slave", client.number(0x1F81, NODE) == 5, client.read(0x1F81, NODE))
    checks.check("1F88h has its serial number", client.number(0x1F85, NODE) == 0xABCD, client.read(0x1F85, NODE))
    text = pathlib.Path(arguments.dcf).read_bytes()
    checks.check("1F20h is its DCF", client.read(0x1F20, NODE) == text, len(client.read(0x1F20, NODE)))
    checks.check("1F21h tells its format", client.number(0x1F21, NODE) == 0)
    concise = client.read(0x1F22, NODE)
    checks.check("1F22h is a concise DCF", int.from_bytes(concise[:4], "little") > 2 and len(concise) > 40, concise)
    checks.check("1F82h tells that the slave runs", client.number(0x1F82, NODE) == 5, client.read(0x1F82, NODE))
    checks.check("a domain that is not there is no data", client.write(0x1F20, 5, b"\x00") != 0)


def command(checks, client, slave, arguments):
    checks.check("1F82h stops the slave", client.write(0x1F82, NODE, STOP) == 0
                 and eventually(lambda: slave.state() == "STOPPED"), slave.state())
    checks.check("1F82h starts the slave", client.write(0x1F82, NODE, START) == 0
                 and eventually(lambda: slave.state() == "OPERATIONAL"), slave.state())
    client.write(0x1F82, NODE, STOP)
    before = client.count(0, b"\x01" + bytes([NODE]))
    client.write(0x1F82, ALL, START)
    checks.check("a start of all is one for each", eventually(
        lambda: client.count(0, b"\x01" + bytes([NODE])) == before + 1))
    time.sleep(arguments.patience)
    checks.check("there was no start of node 0", client.count(0, b"\x01\x00") == 0)
    checks.check("nor of the safety slave", client.count(0, b"\x01" + bytes([SAFETY])) == 0)


def refuse(checks, client):
    for name, index, sub, data, abort in (
            ("1F81h of the safety slave", 0x1F81, SAFETY, bytes(4), 0x06010002),
            ("1F85h of the safety slave", 0x1F85, SAFETY, bytes(4), 0x06010002),
            ("a concise DCF for the safety slave", 0x1F22, SAFETY, bytes(4), 0x06010002),
            ("1F81h that takes a slave out", 0x1F81, NODE, bytes(4), 0x08000022),
            ("1F81h of a node that is no slave", 0x1F81, 99, b"\x01\x00\x00\x00", 0x08000022),
            ("1F80h without the manager's bit", 0x1F80, 0, bytes(4), 0x08000022),
            ("1F82h for a node that is no slave", 0x1F82, 99, START, 0x06090030),
            ("1F82h with another value", 0x1F82, NODE, b"\x03", 0x06090030),
            ("1F25h with another value", 0x1F25, NODE, b"conn", 0x08000020),
            ("1F90h of a manager that does not fly", 0x1F90, 3, b"\x00\x00", 0x06020000),
            ("a safety object of the manager", 0x1301, 1, b"\x01", 0x06020000)):
        code = client.write(index, sub, data)
        checks.check(f"{name} is refused with {abort:08X}", code == abort, f"{code:08X}")
    checks.check("another heartbeat time is taken", client.write(0x1017, 0, b"\x32\x00") == 0)
    before = client.count(0x700 + MANAGER, b"\x05")
    time.sleep(2)
    checks.check("and kept", client.count(0x700 + MANAGER, b"\x05") - before >= 20,
                 client.count(0x700 + MANAGER, b"\x05") - before)
    long = bytes.fromhex("02000000002000040000007856341201200001000000ff")
    checks.check("a concise DCF is downloaded in segments", client.write(0x1F22, NODE, long) == 0)
    checks.check("and read back", client.read(0x1F22, NODE) == long, client.read(0x1F22, NODE))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--can", required=True)
    parser.add_argument("--dcf", required=True)
    parser.add_argument("--safety-dcf", required=True)
    parser.add_argument("--program", required=True)
    parser.add_argument("--patience", type=int, default=1)
    arguments = parser.parse_args()
    dcf, safety = (str(pathlib.Path(name).resolve()) for name in (arguments.dcf, arguments.safety_dcf))
    checks = Checks()
    slave = Slave(arguments.can, dcf)
    client = Client(arguments.can)
    with tempfile.TemporaryDirectory() as folder:
        network = pathlib.Path(folder) / "net.yaml"
        network.write_text(f"manager: {{node: {MANAGER}, heartbeat: 200 ms}}\nslaves:\n"
                           f"  - {{node: {NODE}, dcf: {dcf}, mandatory: false}}\n"
                           f"  - {{node: {SAFETY}, dcf: {safety}, mandatory: false}}\n")
        process = subprocess.Popen([arguments.program, "manager", "--can", arguments.can, "--network", str(network),
                                    "--no-input"], stdout=subprocess.DEVNULL)
        checks.check("the slave runs", eventually(lambda: slave.state() == "OPERATIONAL"))
        look(checks, client, arguments)
        command(checks, client, slave, arguments)
        refuse(checks, client)
        process.terminate()
        checks.check("the manager ends with 0", process.wait(60) == 0, process.returncode)
    client.close()
    slave.close()
    return 1 if checks.failures else 0


if __name__ == "__main__":
    sys.exit(main())
