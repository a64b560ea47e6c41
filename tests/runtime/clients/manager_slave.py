#!/usr/bin/env python3
"""`counterpoint manager` boots a slave of other origin (canopen, python-can).

    manager_slave.py --can ADDRESS --dcf FILE --program COUNTERPOINT

The slave is a LocalNode of python-canopen with the objects of the DCF. Booted by a CPJ file, then refused because of another
vendor-ID, then lost and found again. Each check waits for what it expects, not for seconds. One line a check; exit status 0 only when all hold.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile
import threading
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import canopen  # noqa: E402
from node_bus import open_bus  # noqa: E402

NODE = 10
FILTER = 0x2000
NAME = 0x2001
PATIENCE = 60  # Seconds after which what has not come never will.


class Checks:
    """What was checked, and what did not hold."""

    def __init__(self):
        self.failures = 0

    def check(self, what, holds, detail=""):
        self.failures += 0 if holds else 1
        print(f"{'ok  ' if holds else 'FAIL'} {what}{'' if holds else ': ' + str(detail)}", flush=True)


class Slave:
    """The node of other origin, on a bus connection of its own."""

    def __init__(self, address, dcf):
        self.network = canopen.Network()
        self.network.bus = open_bus(address)
        self.network.connect()
        self.dcf = dcf
        self.node = None
        self.put_in()

    def put_in(self):
        self.node = self.network.create_node(NODE, self.dcf)
        self.network.subscribe(0, self.on_command)  # After the node's own.
        self.start()

    def start(self):
        """python-canopen leaves it to the application to come back from a reset."""
        self.node.nmt.stop_heartbeat()
        self.node.nmt.send_command(0)  # Boot-up message.
        self.node.nmt.state = "PRE-OPERATIONAL"

    def on_command(self, _identifier, data, _time):
        is_reset = len(data) == 2 and data[0] in (129, 130) and data[1] in (0, NODE)
        if is_reset and self.node is not None:
            self.start()

    def pull(self):
        self.node.nmt.stop_heartbeat()
        self.node = None
        self.network.unsubscribe(0, self.on_command)
        del self.network[NODE]

    def state(self):
        return self.node.nmt.state

    def value(self, index):
        return self.node.sdo[index].raw

    def close(self):
        self.pull()
        self.network.disconnect()


class Manager:
    """`counterpoint manager`, its events as they come; it runs until it is told to quit."""

    def __init__(self, arguments, network):
        command = [arguments.program, "manager", "--can", arguments.can, "--network", str(network), "--node-id", "127", "--json"]
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.events = []
        self.reader = threading.Thread(target=self.read)
        self.reader.start()

    def read(self):
        self.events.extend(json.loads(line) for line in self.process.stdout)

    def count(self, key, value):
        """How many events had this."""
        return sum(1 for event in list(self.events) if event.get(key) == value)

    def end(self):
        """Status of the end, exit status."""
        self.process.stdin.write("quit\n")
        self.process.stdin.close()
        self.reader.join()
        return self.events[-1], self.process.wait()


def eventually(holds):
    """However long that takes on a busy machine; what never comes does not hold."""
    end = time.monotonic() + PATIENCE
    while not holds() and time.monotonic() < end:
        time.sleep(0.05)
    return holds()


def boot(checks, arguments, folder):
    slave = Slave(arguments.can, arguments.dcf)
    network = folder / "net.cpj"
    network.write_text("[Topology]\nNetName=Third party\nNodes=1\nNode10Present=1\nNode10Name=Plain\n"
                       f"Node10DCFName={arguments.dcf}\n")
    manager = Manager(arguments, network)
    checks.check("it is OPERATIONAL", eventually(lambda: slave.state() == "OPERATIONAL"), slave.state())
    checks.check("the manager hears so", eventually(lambda: manager.count("state", "operational") > 0), manager.events)
    status, code = manager.end()
    checks.check("a slave of other origin boots", code == 0 and status["slaves"][0]["good"], status)
    checks.check("its heartbeat was set", slave.value(0x1017) == 100, slave.value(0x1017))
    checks.check("a number was configured", slave.value(FILTER) == 0x12345678, slave.value(FILTER))
    checks.check("a text was configured, in segments", slave.value(NAME) == "a name that needs segments",
                 slave.value(NAME))
    slave.close()


def refuse(checks, arguments, folder):
    slave = Slave(arguments.can, arguments.dcf)
    network = folder / "other.yaml"
    network.write_text("manager: {node: 127, boot_time: 1 s}\n"
                       f"slaves: [{{node: 10, dcf: {arguments.dcf}, vendor_id: 0xABCE}}]\n")
    manager = Manager(arguments, network)
    checks.check("the manager tells it", eventually(lambda: manager.count("letter", "D") > 0), manager.events)
    status, code = manager.end()
    row = status["slaves"][0]
    checks.check("another vendor-ID is letter D", code == 1 and row["letter"] == "D", status)
    checks.check("the finding says what was read", row["finding"] == "vendor-ID differs: 0x1018:01 is 0xABCD, expected 0xABCE", row)
    checks.check("it was not started", slave.state() == "PRE-OPERATIONAL", slave.state())
    slave.close()


def lose(checks, arguments, folder):
    slave = Slave(arguments.can, arguments.dcf)
    network = folder / "net.yaml"
    network.write_text(f"manager: {{node: 127}}\nslaves: [{{node: 10, dcf: {arguments.dcf}}}]\n")

    manager = Manager(arguments, network)
    checks.check("it is started", eventually(lambda: slave.state() == "OPERATIONAL"), slave.state())
    before = manager.count("event", "heartbeat_lost")
    slave.pull()
    checks.check("its loss is told", eventually(lambda: manager.count("event", "heartbeat_lost") > before), manager.events)
    slave.put_in()
    checks.check("it is started again when it is back", eventually(lambda: slave.state() == "OPERATIONAL"), slave.state())
    lost = manager.count("event", "heartbeat_lost") - before
    checks.check("the loss is told once", lost == 1, lost)
    manager.end()
    slave.close()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--can", required=True)
    parser.add_argument("--dcf", required=True)
    parser.add_argument("--program", required=True)
    arguments = parser.parse_args()
    arguments.dcf = str(pathlib.Path(arguments.dcf).resolve())
    checks = Checks()
    with tempfile.TemporaryDirectory() as folder:
        for part in (boot, refuse, lose):
            part(checks, arguments, pathlib.Path(folder))
    return 1 if checks.failures else 0


if __name__ == "__main__":
    sys.exit(main())
