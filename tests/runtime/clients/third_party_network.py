#!/usr/bin/env python3
"""`counterpoint manager` and a network with a slave of other origin and a safety slave, in each of its three profiles.

    third_party_network.py --can ADDRESS --dcf FILE --safety-dcf FILE --program COUNTERPOINT
                           [--profile NAME] [--patience N] [--cycle-us N]

The slave of other origin (third_party_slave.py) is booted, killed, started and booted again; one that is another device
is refused. A listener of other origin (python-can) watches what is really sent. --patience N gives a slow machine N
times the time. One line a check; exit status 0 only when all hold.
"""
import argparse
import contextlib
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

HERE = pathlib.Path(__file__).resolve().parent
OTHER, SAFETY = 10, 33
NMT, SDO_ANSWER, ERROR_CONTROL = 0, 0x580, 0x700
START, START_ALL = 1, b"\x01\x00"
OPERATIONAL = 5
SIGNATURE = bytes.fromhex("ff1301")  # 13FFh:01 in an SDO
FILTER, NAME = 0x2000, 0x2001


class Profile:
    """What a network file says more for it, and what the status has to be."""

    def __init__(self, name, more, started, lost, wrong):
        self.name, self.more = name, more
        self.started, self.lost = started, lost
        # Options of another device, what it is refused with, and the finding.
        self.other_device, self.refused, self.finding = wrong


SERIAL = "0x1018:04 is 0x8, expected 0x7"
PROFILES = [Profile("cia302", "", {"letter": ""}, {"state": "missing"},
                    (["--serial", "8"], {"letter": "O"}, "serial number differs: " + SERIAL)),
            Profile("el6751", "", {"code": 0}, {"code": 2},
                    (["--serial", "8"], {"code": 5}, "SDO value differs: " + SERIAL)),
            # It compares the low 16 bits of 1000h and nothing of 1018h.
            Profile("plc_designer", ", plc_designer: {reset_node: true}", {"code": 5}, {"code": 99},
                    (["--device-type", "0x192"], {"code": 98}, "device type differs: 0x1000:00 is 0x192, expected 0x191"))]


class Listener:
    """All frames of the bus as another stack sees them, and a client that reads what the slave was given."""

    def __init__(self, address, dcf):
        self.frames = []
        self.network = canopen.Network()
        self.network.bus = open_bus(address)
        self.network.listeners.append(
            lambda message: self.frames.append((message.arbitration_id, bytes(message.data))))
        self.network.connect()
        self.client = self.network.add_node(OTHER, dcf)
        self.client.sdo.RESPONSE_TIMEOUT = 5.0

    def data_of(self, identifier):
        return [data for which, data in list(self.frames) if which == identifier]

    def starts(self, node):
        return self.data_of(NMT).count(bytes([START, node]))

    def state(self, node):
        signs = self.data_of(ERROR_CONTROL + node)
        return signs[-1][0] if signs else None

    def was_read_before_start(self, node):
        """The signature was read before the first start of the node."""
        frames = list(self.frames)
        start = frames.index((NMT, bytes([START, node])))
        return any(which == SDO_ANSWER + node and data[1:4] == SIGNATURE for which, data in frames[:start])

    def close(self):
        self.network.disconnect()


class Manager:
    """The running command; its events and answers."""

    def __init__(self, arguments, network):
        self.lines = []
        command = [arguments.program, "manager", "--can", arguments.can, "--network", str(network), "--json"]
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.reader = threading.Thread(target=self.read)
        self.reader.start()

    def read(self):
        for line in self.process.stdout:
            self.lines.append(json.loads(line))

    def events(self, kind, node):
        return [line for line in list(self.lines) if line["event"] == kind and line.get("node") == node]

    def rows(self):
        """The rows of a fresh status by node-ID, none while the manager has not answered."""
        before = len(self.lines)
        self.process.stdin.write("status\n")
        self.process.stdin.flush()
        answers = eventually(lambda: [line for line in self.lines[before:] if "slaves" in line], 10)
        return {row["node"]: row for row in answers[0]["slaves"]} if answers else {}

    def end(self):
        """Exit status, after the end was asked for."""
        if self.process.poll() is None:
            self.process.terminate()
        self.process.wait(60)
        self.reader.join()
        self.process.stdin.close()
        return self.process.returncode


class Bench:
    """One profile's network: programs, listener, and what did not hold."""

    def __init__(self, arguments, profile, folder):
        self.arguments, self.profile = arguments, profile
        self.failures = 0
        self.network = folder / f"{profile.name}.yaml"
        time_out = f"{arguments.patience} s"
        # 1F80h asks for one start of all, which must not come: a safety slave is there.
        self.network.write_text(
            f"manager: {{node: 127, profile: {profile.name}, start_up: 3, heartbeat: 1 s, sdo_timeout: {time_out}}}\n"
            f"slaves:\n"
            f"  - {{node: {OTHER}, name: Other, dcf: {arguments.dcf}, consumer: {time_out}{profile.more}}}\n"
            f"  - {{node: {SAFETY}, name: Relay, dcf: {arguments.safety_dcf}, consumer: {time_out}}}\n",
            encoding="utf-8")

    def check(self, what, holds, detail=""):
        self.failures += 0 if holds else 1
        print(f"{'ok  ' if holds else 'FAIL'} {self.profile.name}: {what}{'' if holds else f': {detail}'}", flush=True)
        return holds

    def slave(self, *more):
        return subprocess.Popen([sys.executable, str(HERE / "third_party_slave.py"), "--can", self.arguments.can,
                                 "--dcf", self.arguments.dcf, *more])

    def safety_slave(self):
        command = [self.arguments.program, "node", "--can", self.arguments.can, "--dcf", self.arguments.safety_dcf,
                   "--no-input", "--cycle-us", str(self.arguments.cycle_us)]
        return subprocess.Popen(command, stdout=subprocess.DEVNULL)

    def reaches(self, what, manager, condition):
        """The status comes to be as the condition wants it."""
        seen = {}

        def looked():
            seen.update(manager.rows())
            return seen and condition(seen)
        return self.check(what, eventually(looked, 15 * self.arguments.patience), (seen, manager.lines[-20:]))


def eventually(condition, seconds):
    """What the condition answers, once it is true or when the time is over."""
    end = time.monotonic() + seconds
    answer = condition()
    while not answer and time.monotonic() < end:
        time.sleep(0.1)
        answer = condition()
    return answer


def shows(row, expected):
    return all(row[key] == value for key, value in expected.items())


def runs(row, profile):
    return row["good"] and row["state"] == "operational" and shows(row, profile.started)


@contextlib.contextmanager
def running(process):
    """Ends a device at the end, whatever happened."""
    try:
        yield process
    finally:
        process.kill()
        process.wait()


@contextlib.contextmanager
def managed(bench):
    """A listener and a manager behind it, both ended at the end."""
    listener = Listener(bench.arguments.can, bench.arguments.dcf)
    manager = Manager(bench.arguments, bench.network)
    try:
        yield listener, manager
    finally:
        manager.end()
        listener.close()


def check_start(bench, listener, manager):
    """Both run, each by a start of its own, with what the DCF says."""
    profile = bench.profile
    bench.reaches("the slave of other origin is OPERATIONAL", manager, lambda rows: runs(rows[OTHER], profile))
    bench.reaches("the safety slave is verified and OPERATIONAL", manager,
                  lambda rows: runs(rows[SAFETY], profile) and rows[SAFETY]["safety"] == "open")
    runs_itself = eventually(lambda: listener.state(OTHER) == OPERATIONAL, bench.arguments.patience)
    bench.check("its own heartbeat says so", runs_itself, listener.state(OTHER))
    given = [listener.client.sdo[index].raw for index in (FILTER, NAME)]
    bench.check("it was configured, in one frame and in segments",
                given == [0x12345678, "a name that needs segments"], given)
    bench.check("each was started once, by a command to it alone",
                [listener.starts(OTHER), listener.starts(SAFETY)] == [1, 1], listener.data_of(NMT))
    bench.check("the safety configuration was read before", listener.was_read_before_start(SAFETY))


def check_return(bench, slave, listener, manager):
    """The slave's process dies without a word and is started again."""
    slave.kill()
    slave.wait()
    bench.reaches("its death is noticed", manager,
                  lambda rows: not rows[OTHER]["good"] and shows(rows[OTHER], bench.profile.lost))
    losses = manager.events("heartbeat_lost", OTHER)
    bench.check("the loss is told once", len(losses) == 1, losses)
    with running(bench.slave()):
        bench.reaches("back again, it is booted again", manager, lambda rows: runs(rows[OTHER], bench.profile))
        bench.check("by a second start", listener.starts(OTHER) == 2, listener.data_of(NMT))
        bench.check("configured anew", listener.client.sdo[FILTER].raw == 0x12345678, listener.client.sdo[FILTER].raw)
        bench.reaches("the safety slave runs", manager, lambda rows: runs(rows[SAFETY], bench.profile))
        bench.check("the manager ends with 0", manager.end() == 0, (manager.process.returncode, manager.lines[-1:]))


def boot_and_lose(bench):
    with running(bench.safety_slave()), running(bench.slave()) as slave, managed(bench) as (listener, manager):
        check_start(bench, listener, manager)
        check_return(bench, slave, listener, manager)
        bench.check("no start of all nodes", START_ALL not in listener.data_of(NMT), listener.data_of(NMT))


def refuse(bench):
    profile = bench.profile
    other_device = bench.slave(*profile.other_device)
    with running(other_device), running(bench.safety_slave()), managed(bench) as (listener, manager):
        bench.reaches(f"another device is refused, {profile.refused}", manager,
                      lambda rows: shows(rows[OTHER], profile.refused))
        time.sleep(2 * bench.arguments.patience)  # A start would have to come within this time.
        row = manager.rows()[OTHER]
        bench.check("the finding says what was read", row["finding"] == profile.finding, row)
        bench.check("it stays refused and is never started",
                    shows(row, profile.refused) and not row["good"] and listener.starts(OTHER) == 0 and
                    listener.state(OTHER) != OPERATIONAL, (row, listener.data_of(NMT)))
        bench.check("nor is it by a start of all nodes", START_ALL not in listener.data_of(NMT), listener.data_of(NMT))
        bench.check("the manager ends with 1", manager.end() == 1, manager.process.returncode)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--can", required=True)
    parser.add_argument("--dcf", required=True)
    parser.add_argument("--safety-dcf", required=True)
    parser.add_argument("--program", required=True)
    parser.add_argument("--profile", choices=[profile.name for profile in PROFILES])
    parser.add_argument("--patience", type=int, default=1)
    parser.add_argument("--cycle-us", type=int, default=20000)
    arguments = parser.parse_args()
    arguments.dcf = str(pathlib.Path(arguments.dcf).resolve())
    arguments.safety_dcf = str(pathlib.Path(arguments.safety_dcf).resolve())
    failures = 0
    with tempfile.TemporaryDirectory() as folder:
        for profile in PROFILES:
            if arguments.profile in (None, profile.name):
                bench = Bench(arguments, profile, pathlib.Path(folder))
                boot_and_lose(bench)
                refuse(bench)
                failures += bench.failures
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
