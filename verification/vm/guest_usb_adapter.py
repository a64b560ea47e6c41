"""A USB CAN adapter made of software, for checks in the virtual machine: Linux's own driver usb_8dev drives it.

QEMU's emulated SJA1000 knows no error counters, no bus-off and an endless bus, so what happens then cannot be seen with
it. Here the kernel's real path runs: the adapter tells of bus-off by a status message, the driver calls can_bus_off(),
the carrier goes away, and a restart reaches the adapter as the command to open. The adapter is connected through the
virtual USB host vhci_hcd, whose messages (USB/IP) come over a socket.

Orders, one a file /tmp/adapter.orders, taken away when read:
  busoff | warning | passive | active   the controller's state as the adapter tells it
  hold | release                        frames to send are kept, as on a bus without acknowledgement; and go out
  frame ID HEX                          a frame comes from the bus
"""
import os
import pathlib
import select
import socket
import struct
import sys

ORDERS = pathlib.Path("/tmp/adapter.orders")
ATTACH = pathlib.Path("/sys/devices/platform/vhci_hcd.0/attach")
FULL_SPEED, PORT, DEVICE = 2, 0, 1
SUBMIT, UNLINK, SUBMITTED, UNLINKED = 1, 2, 3, 4
PIPE_BROKEN, CONNECTION_RESET = -32, -104
STATES = {"active": (0x00, 0, 0), "warning": (0x02, 0, 96), "passive": (0x03, 0, 128), "busoff": (0x04, 0, 248)}
COMMAND_OPEN, COMMAND_VERSION = 2, 12

DEVICE_DESCRIPTOR = struct.pack("<BBHBBBBHHHBBBB", 18, 1, 0x0110, 0xFF, 0, 0, 64, 0x0483, 0x1234, 0x0100, 1, 2, 3, 1)
ENDPOINTS = b"".join(struct.pack("<BBBBHB", 7, 5, address, 2, 64, 0) for address in (0x81, 0x02, 0x83, 0x04))
INTERFACE = struct.pack("<BBBBBBBBB", 9, 4, 0, 0, 4, 0xFF, 0, 0, 0)
CONFIGURATION = struct.pack("<BBHBBBBB", 9, 2, 9 + len(INTERFACE) + len(ENDPOINTS), 1, 1, 0, 0x80, 50) + INTERFACE + ENDPOINTS
STRINGS = ["", "Counterpoint", "USB2CAN converter", "1"]


def descriptor(kind, index):
    """The bytes of a descriptor; None: there is none."""
    if kind == 1:
        return DEVICE_DESCRIPTOR
    if kind == 2:
        return CONFIGURATION
    if kind == 3 and index == 0:
        return struct.pack("<BBH", 4, 3, 0x0409)
    if kind == 3 and index < len(STRINGS):
        text = STRINGS[index].encode("utf-16-le")
        return struct.pack("<BB", 2 + len(text), 3) + text
    return None


class Adapter:
    """Requests of the host that wait (by endpoint), and what waits for them."""

    def __init__(self, link):
        self.link = link
        self.reads = {1: [], 3: []}
        self.ready = {1: [], 3: []}
        self.held, self.is_held, self.is_off = [], False, False

    def answer(self, number, status, data=b"", count=None):
        actual = len(data) if count is None else count
        self.link.sendall(struct.pack(">IIIII iiiii 8x", SUBMITTED, number, 0, 0, 0, status, actual, 0, 0, 0) + data)

    def give(self, endpoint, data):
        self.ready[endpoint].append(data)
        self.serve()

    def serve(self):
        for endpoint, reads in self.reads.items():
            while reads and self.ready[endpoint]:
                self.answer(reads.pop(0), 0, self.ready[endpoint].pop(0))

    def control(self, number, setup, length):
        request_type, request, value, _, _ = struct.unpack("<BBHHH", setup)
        if request_type == 0x80 and request == 6:
            data = descriptor(value >> 8, value & 0xFF)
            self.answer(number, PIPE_BROKEN if data is None else 0, b"" if data is None else data[:length])
        elif request_type == 0x80 and request == 0:
            self.answer(number, 0, b"\0\0"[:length])
        elif request in (9, 11, 1):
            self.answer(number, 0)
        else:
            self.answer(number, PIPE_BROKEN)

    def command(self, data):
        code = data[2]
        result = bytes([1, 0, 1, 0]) if code == COMMAND_VERSION else bytes(4)
        self.give(3, bytes([0x11, 0, code, 0, 0]) + result + bytes(6) + bytes([0x22]))
        if code == COMMAND_OPEN and self.is_off:
            self.is_off = False
            self.status("active")
            self.release()

    def status(self, name):
        code, receive_errors, transmit_errors = STATES[name]
        self.is_off = name == "busoff"
        self.message(3, 4, 0, bytes([code, receive_errors, transmit_errors, 0]))

    def message(self, kind, flags, identifier, data):
        packed = struct.pack(">BBBIB8sIB", 0x55, kind, flags, identifier, len(data), data.ljust(8, b"\0"), 0, 0xAA)
        self.give(1, packed)

    def release(self):
        for number, count in self.held:
            self.answer(number, 0, count=count)
        self.held = []

    def submit(self, number, direction, endpoint, length, setup, data):
        if endpoint == 0:
            self.control(number, setup, length)
        elif direction == 1:
            self.reads[endpoint].append(number)
            self.serve()
        elif endpoint == 4:
            self.answer(number, 0, count=len(data))
            self.command(data)
        else:
            self.held.append((number, len(data)))
            if not (self.is_held or self.is_off):
                self.release()

    def unlink(self, number, victim):
        known = False
        for reads in self.reads.values():
            known = known or victim in reads
            reads[:] = [read for read in reads if read != victim]
        known = known or any(held == victim for held, _ in self.held)
        self.held = [(held, count) for held, count in self.held if held != victim]
        self.link.sendall(struct.pack(">IIIII i 24x", UNLINKED, number, 0, 0, 0, CONNECTION_RESET if known else 0))

    def obey(self, words):
        if words[0] in STATES:
            self.status(words[0])
        elif words[0] == "hold":
            self.is_held = True
        elif words[0] == "release":
            self.is_held = False
            self.release()
        elif words[0] == "frame":
            self.message(0, 0, int(words[1], 16), bytes.fromhex(words[2]) if len(words) > 2 else b"")
        else:
            sys.exit(f"order '{' '.join(words)}', expected one of those at the head of this file")


def read_exactly(link, count):
    data = b""
    while len(data) < count:
        got = link.recv(count - len(data))
        if not got:
            sys.exit(0)
        data += got
    return data


def main():
    own, host = socket.socketpair(socket.AF_UNIX, socket.SOCK_STREAM)
    ATTACH.write_text(f"{PORT} {host.fileno()} {DEVICE} {FULL_SPEED}", encoding="ascii")
    os.close(host.detach())
    adapter = Adapter(own)
    while True:
        if select.select([own], [], [], 0.01)[0]:
            head = read_exactly(own, 48)
            command, number, _, direction, endpoint = struct.unpack_from(">IIIII", head)
            if command == SUBMIT:
                length, = struct.unpack_from(">i", head, 24)
                data = read_exactly(own, length) if direction == 0 and length > 0 else b""
                adapter.submit(number, direction, endpoint, length, head[40:48], data)
            elif command == UNLINK:
                adapter.unlink(number, struct.unpack_from(">I", head, 20)[0])
        elif ORDERS.exists():
            words = ORDERS.read_text(encoding="ascii").split()
            ORDERS.unlink()
            adapter.obey(words)


if __name__ == "__main__":
    main()
