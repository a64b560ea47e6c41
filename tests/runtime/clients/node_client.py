#!/usr/bin/env python3
"""A CANopen client of other origin (canopen, python-can) talks to a running `counterpoint node`.

    node_client.py --can ADDRESS --dcf FILE [--node N] [--program COUNTERPOINT] [--cycle-us N] [--patience N]

Walks all objects of the DCF, transfers expedited, segmented and in blocks, follows NMT and heartbeat, configures the safety
part, provokes emergencies. With --program it starts the node itself; --patience N gives a slow machine N times the time. One line a check; exit status 0 only when all hold.
"""
import argparse
import contextlib
import logging
import pathlib
import struct
import subprocess
import sys
import threading
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import canopen  # noqa: E402
from canopen.objectdictionary import datatypes  # noqa: E402
from canopen.sdo import SdoAbortedError, SdoCommunicationError  # noqa: E402
from node_bus import open_bus  # noqa: E402
from node_client_safety import safety  # noqa: E402

TEXT = (datatypes.VISIBLE_STRING, datatypes.OCTET_STRING, datatypes.DOMAIN)
LIVING = {0x1001, 0x1003, 0x1010, 0x1011, 0x1014}  # Values that come from the device, not from the file.
DOMAIN_INDEX = 0x400F
STRING_INDEX = 0x4009


class Session:
    """One network with one node, and what was checked."""

    def __init__(self, address, dcf, node_id, patience):
        self.patience = patience
        self.failures = []
        self.checks = 0
        self.network = canopen.Network()
        self.network.bus = open_bus(address)
        self.frames = []
        self.lock = threading.Lock()
        self.network.listeners.append(self.record)
        self.network.connect()
        self.node = self.network.add_node(node_id, dcf)
        self.node.sdo.RESPONSE_TIMEOUT = 2.0 * patience
        self.node.sdo.MAX_RETRIES = 1
        self.id = node_id

    def record(self, message):
        with self.lock:
            self.frames.append((time.monotonic(), message.arbitration_id, bytes(message.data)))

    def heard(self, identifier, since=0.0):
        with self.lock:
            return [(at, data) for at, which, data in self.frames if which == identifier and at >= since]

    def wait_for(self, identifier, since, accept=lambda data: True, timeout=3.0):
        end = time.monotonic() + timeout * self.patience
        while time.monotonic() < end:
            for _, data in self.heard(identifier, since):
                if accept(data):
                    return data
            time.sleep(0.005)
        return None

    def check(self, what, holds, detail=""):
        self.checks += 1
        line = f"{'ok  ' if holds else 'FAIL'} {what}{'' if holds else ': ' + str(detail)}"
        self.failures += [] if holds else [line]
        print(line, flush=True)

    def abort_of(self, call, *arguments):
        """The abort code of a refused transfer, 0 if it was accepted."""
        try:
            call(*arguments)
        except SdoAbortedError as error:
            return error.code
        return 0

    def write(self, index, sub, value, size):
        return self.abort_of(self.node.sdo.download, index, sub, value.to_bytes(size, "little"))

    def read(self, index, sub):
        return int.from_bytes(self.node.sdo.upload(index, sub), "little")

    def sleep(self, seconds):
        time.sleep(seconds * self.patience)

    def command(self, code):
        since = time.monotonic()
        self.network.send_message(0, [code, self.id])
        return since

    def state_is(self, byte, since):
        """By a heartbeat after the command."""
        return self.wait_for(0x700 + self.id, since, lambda data: data == bytes([byte])) is not None


def variables(session):
    for entry in session.node.object_dictionary.values():
        if entry.index < 0x1000:  # Data types: dummies of mappings.
            continue
        if isinstance(entry, canopen.objectdictionary.ODVariable):
            yield entry
        else:
            yield from (entry[sub] for sub in sorted(entry.subindices))


def expected_bytes(variable):
    """What the file says, None where it says nothing that can be compared."""
    value = variable.value if variable.value is not None else variable.default
    if value is None or variable.index in LIVING:
        return None
    if variable.data_type == datatypes.VISIBLE_STRING:
        return str(value).encode("latin-1")
    if variable.data_type in TEXT:
        return None
    return variable.encode_raw(value)


def walk(session):
    """Every object: present as the file says, with its value, its access rights, written back as it is."""
    count = refused = differing = 0
    for variable in variables(session):
        count += 1
        name = f"0x{variable.index:04X}:{variable.subindex:02X} {variable.name}"
        if variable.access_type == "wo":
            code = session.abort_of(session.node.sdo.upload, variable.index, variable.subindex)
            session.check(f"{name} is write-only", code == 0x06010001, hex(code))
            continue
        try:
            data = session.node.sdo.upload(variable.index, variable.subindex)
        except SdoAbortedError as error:
            is_empty = variable.index == 0x1003 and error.code == 0x08000024
            refused += 0 if is_empty else 1
            if not is_empty:
                session.check(f"{name} can be read", False, error)
            continue
        wanted = expected_bytes(variable)
        if wanted is not None and data != wanted:
            differing += 1
            session.check(f"{name} has the value of the file", False, f"{data.hex()} instead of {wanted.hex()}")
        code = session.abort_of(session.node.sdo.download, variable.index, variable.subindex, data)
        right = 0x06010002 if variable.access_type in ("ro", "const") else 0
        # The kernel takes identical values of its parameters, and lets nobody write what an SRDO receives.
        is_kernels = 0x1300 <= variable.index <= 0x13FF or variable.index in (0x2200, 0x2300)
        if code != right and variable.index not in (0x1003, 0x1010, 0x1011) and not is_kernels:
            session.check(f"{name} ({variable.access_type}) written back", False, f"{code:08X} instead of {right:08X}")
    session.check(f"all {count} variables of the file are there, {refused} refused", refused == 0)
    session.check("all values are those of the file", differing == 0)
    session.check("identical values do not clear 13FEh", session.read(0x13FE, 0) == 0xA5)
    code = session.abort_of(session.node.sdo.upload, 0x3333, 0)
    session.check("unknown object", code == 0x06020000, hex(code))
    code = session.abort_of(session.node.sdo.upload, 0x1018, 9)
    session.check("unknown sub-index", code == 0x06090011, hex(code))


def numbers(session):
    """Limits, lengths, signs."""
    sdo = session.node.sdo
    for value, right in ((2, 0x06090032), (3, 0), (200, 0), (201, 0x06090031)):
        code = session.write(0x4005, 0, value, 1)
        session.check(f"UNSIGNED8 with limits takes {value}: {right:08X}", code == right, hex(code))
    for value, right in ((-11, 0x06090032), (-10, 0), (10, 0), (11, 0x06090031)):
        code = session.abort_of(sdo.download, 0x4002, 0, struct.pack("b", value))
        session.check(f"INTEGER8 with limits takes {value}: {right:08X}", code == right, hex(code))
    code = session.write(0x4007, 0, 1, 2)
    session.check("too short", code == 0x06070013, hex(code))
    code = session.abort_of(sdo.download, 0x4006, 0, b"1234567890")
    session.check("too long", code in (0x06070012, 0x06070010), hex(code))
    code = session.write(0x1010, 1, 1, 4)
    session.check("a save without its signature: 08000020", code == 0x08000020, hex(code))
    code = session.write(0x5F00, 1, session.read(0x5F00, 1) + 1, 4)
    session.check("5F00h cannot change while the device runs", code == 0x08000021, hex(code))


def transfers(session):
    """All three kinds, both ways, of lengths around the borders of segments and blocks."""
    sdo = session.node.sdo
    for length in (1, 4, 5, 7, 8, 14, 100, 255):
        text = bytes(32 + n % 90 for n in range(length))
        sdo.download(STRING_INDEX, 0, text, force_segment=True)
        session.check(f"segmented, {length} bytes there and back", sdo.upload(STRING_INDEX, 0) == text)
    for length in (1, 7, 8, 448, 449, 889, 890, 8192):
        data = bytes((n * 7 + length) & 0xFF for n in range(length))
        started = time.monotonic()
        with sdo.open(DOMAIN_INDEX, 0, "wb", size=length, block_transfer=True) as stream:
            stream.write(data)
        with sdo.open(DOMAIN_INDEX, 0, "rb", block_transfer=True) as stream:
            back = stream.read()
        rate = 2 * length / (time.monotonic() - started) / 1000
        session.check(f"block, {length} bytes there and back, {rate:.0f} kB/s", back == data, f"{len(back)} bytes")
    session.check("block written, segmented read", sdo.upload(DOMAIN_INDEX, 0) == data)


def states(session):
    """NMT commands, boot-up, heartbeat, and which service works where."""
    session.write(0x1017, 0, 50, 2)
    identifier = 0x700 + session.id
    session.check("heartbeat in PRE-OPERATIONAL", session.state_is(127, time.monotonic()))
    session.sleep(0.5)
    beats = [at for at, _ in session.heard(identifier, time.monotonic() - 0.45 * session.patience)]
    gaps = [later - earlier for earlier, later in zip(beats, beats[1:])]
    session.check("heartbeat every 50 ms", gaps and all(0.02 / session.patience < gap < 0.08 * session.patience for gap in gaps), gaps)
    for code, name, byte in ((1, "start", 5), (128, "pre-operational", 127), (2, "stop", 4), (1, "start again", 5)):
        session.check(f"NMT {name}", session.state_is(byte, session.command(code)))
    session.command(2)
    session.sleep(0.1)
    with contextlib.suppress(SdoAbortedError):
        session.node.sdo.RESPONSE_TIMEOUT = 0.3 * session.patience
        try:
            session.node.sdo.upload(0x1000, 0)
            session.check("no SDO in STOPPED", False, "an answer")
        except SdoCommunicationError:
            session.check("no SDO in STOPPED", True)
    session.node.sdo.RESPONSE_TIMEOUT = 2.0 * session.patience
    for code, name in ((130, "reset communication"), (129, "reset node")):
        since = session.command(code)
        session.check(f"boot-up after {name}", session.wait_for(identifier, since, lambda d: d == b"\0") is not None)
        session.sleep(0.1)
        session.check(f"1017h has the value of the file after {name}", session.read(0x1017, 0) == session.heartbeat_of_file)
    since = time.monotonic()
    for code in (1, 128, 1, 2, 128, 1):  # All of them in one burst: the last one counts, none replaces another.
        session.network.send_message(0, [code, session.id])
    session.write(0x1017, 0, 50, 2)
    session.check("six commands at once end in OPERATIONAL", session.state_is(5, time.monotonic()), since)
    for wrong in ([1], [1, session.id, 0], [99, session.id], [2, session.id + 1]):
        session.network.send_message(0, wrong)
    session.check("wrong commands change nothing", session.state_is(5, time.monotonic() + 0.1))
    session.command(128)


def guarding(session):
    """Remote frames: toggle from 0, state, silence while there is a heartbeat; life guarding."""
    session.write(0x1017, 0, 0, 2)
    session.command(130)
    session.sleep(0.2)
    session.write(0x1017, 0, 0, 2)
    answers = []
    for _ in range(3):
        since = time.monotonic()
        session.network.send_message(0x700 + session.id, [], remote=True)
        answers.append(session.wait_for(0x700 + session.id, since, timeout=1.0))
    session.check("guarding: toggle 0, 1, 0", answers == [b"\x7f", b"\xff", b"\x7f"], answers)
    session.write(0x100C, 0, 50 * session.patience, 2)
    session.write(0x100D, 0, 2, 1)
    since = time.monotonic()
    session.network.send_message(0x700 + session.id, [], remote=True)
    lost = session.wait_for(0x80 + session.id, since, lambda d: d[:2] == b"\x30\x81", 1.0)
    session.check("life guarding: emergency 8130h", lost is not None)
    since = time.monotonic()
    session.network.send_message(0x700 + session.id, [], remote=True)
    back = session.wait_for(0x80 + session.id, since, lambda d: d[:2] == b"\0\0", 1.0)
    session.check("life guarding: its end", back is not None)
    session.write(0x100D, 0, 0, 1)


def partners(session):
    """A supervised node that falls silent: emergency, PRE-OPERATIONAL; each for itself."""
    session.write(0x1017, 0, 50, 2)
    session.write(0x1016, 1, 0x00500000 + 100 * session.patience, 4)  # Node 50h, 100 ms.
    session.write(0x1016, 2, 0x00510000 + 100 * session.patience, 4)
    session.command(1)
    for _ in range(3):
        for node in (0x50, 0x51):
            session.network.send_message(0x700 + node, [5])
        session.sleep(0.04)
    since = time.monotonic()
    first = session.wait_for(0x80 + session.id, since, lambda d: d[:2] == b"\x30\x81" and 0x50 in d[3:])
    second = session.wait_for(0x80 + session.id, since, lambda d: d[:2] == b"\x30\x81" and 0x51 in d[3:])
    session.check("each lost node has an emergency 8130h", first and second, (first, second))
    session.check("a lost node leads to PRE-OPERATIONAL", session.state_is(127, since))
    since = time.monotonic()
    session.network.send_message(0x750, [5])
    session.sleep(0.05)
    register = session.read(0x1001, 0)
    session.check("one that returns does not hide the other", register & 0x10 != 0, register)
    for sub in (1, 2):
        session.write(0x1016, sub, 0, 4)
    session.network.send_message(0x751, [5])
    session.command(130)
    session.sleep(0.2)


def process_data(session):
    """RPDO in, TPDO out, SYNC."""
    session.command(1)
    session.sleep(0.1)
    since = time.monotonic()
    session.network.send_message(0x200 + session.id, [0x55, 0xAA])
    sent = session.wait_for(0x180 + session.id, since, lambda d: d[:2] == b"\x55\xaa")
    session.check("RPDO arrives, TPDO tells the change", sent is not None and len(sent) == 6, sent)
    session.check("the object has it", session.read(0x4006, 0) == 0xAA55)
    since = time.monotonic()
    session.network.send_message(0x200 + session.id, [0x55])
    short = session.wait_for(0x80 + session.id, since, lambda d: d[:2] == b"\x10\x82", 1.0)
    session.check("short RPDO: emergency 8210h", short is not None)
    session.command(128)
    session.write(0x1800, 1, 0xC0000180 + session.id, 4)
    session.write(0x1800, 2, 2, 1)
    session.write(0x1800, 1, 0x40000180 + session.id, 4)
    session.command(1)
    session.sleep(0.1)
    since = time.monotonic()
    for _ in range(4):
        session.network.send_message(0x80, [])
        session.sleep(0.03)
    count = len(session.heard(0x180 + session.id, since))
    session.check("TPDO of type 2: two of four SYNCs", count == 2, count)
    session.command(130)
    session.sleep(0.2)


def run(options):
    session = Session(options.can, options.dcf, options.node, options.patience)
    try:
        session.heartbeat_of_file = int(session.node.object_dictionary[0x1017].value or
                                        session.node.object_dictionary[0x1017].default or 0)
        since = session.command(129)
        session.check("the node boots", session.wait_for(0x700 + session.id, since, lambda d: d == b"\0", 5.0) is not None)
        session.sleep(0.2)
        for part in (walk, numbers, transfers, states, guarding, partners, process_data, safety):
            print(f"-- {part.__name__}")
            part(session)
    finally:
        session.network.disconnect()
    print("\n".join(session.failures + [f"{session.checks} checks, {len(session.failures)} failed"]))
    return 1 if session.failures else 0


def main():
    logging.getLogger("canopen").setLevel(logging.CRITICAL)  # Refused transfers are what is asked for.
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--can", required=True)
    parser.add_argument("--dcf", required=True)
    parser.add_argument("--node", type=int, default=2)
    parser.add_argument("--program", help="starts COUNTERPOINT node on the same bus")
    parser.add_argument("--cycle-us", default="5000")
    parser.add_argument("--patience", type=int, default=1)
    options = parser.parse_args()
    if not options.program:
        return run(options)
    process = subprocess.Popen([options.program, "node", "--can", options.can, "--dcf", options.dcf, "--node-id",
                                str(options.node), "--cycle-us", options.cycle_us, "--no-input"],
                               stdout=subprocess.PIPE, text=True)
    try:
        time.sleep(0.5 * options.patience)
        status = run(options)
    finally:
        process.terminate()
        lines = process.communicate(timeout=10)[0].splitlines()
    print("\n".join("node: " + line for line in lines[-3:]))
    return status or process.returncode


if __name__ == "__main__":
    sys.exit(main())
