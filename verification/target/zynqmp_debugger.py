"""A debugger of the emulated machine, by the emulator's own remote protocol: stops at an instruction, reads and writes memory.

    with Machine(images, gdb=True) as machine:
        machine.start(run=False)
        debugger = Debugger(machine)
        debugger.run_to(symbols["TwoCpuPoint"])   # of whichever processor gets there; all of them stand then
        debugger.write(address, b"...")
        debugger.go()

A stop is an instruction, not an instant of the host: what is changed there is changed at the same place of each run.
"""
import subprocess

import zynqmp_machine


def symbols(image):
    """Name -> (address, length) of an ELF file, names as in C++."""
    text = subprocess.run(["arm-none-eabi-nm", "-S", "-C", str(image)], capture_output=True, text=True, check=True).stdout
    found = {}
    for line in text.splitlines():
        parts = line.split(" ", 3)
        if len(parts) == 4 and len(parts[1]) == 8:
            found[parts[3]] = (int(parts[0], 16), int(parts[1], 16))
    return found


class Debugger:
    """One connection to the emulator's debugger port."""

    def __init__(self, machine):
        self.end = machine.ends["gdb"]
        self.end.settimeout(zynqmp_machine.LAST_RESORT_SECONDS)
        self.bytes = b""
        self.ask("qSupported:hwbreak+")

    def _next(self):
        if not self.bytes:
            self.bytes = self.end.recv(4096)
            if not self.bytes:
                raise zynqmp_machine.BadRun("the emulator's debugger port was closed")
        first, self.bytes = self.bytes[:1], self.bytes[1:]
        return first

    def send(self, text):
        self.end.sendall(f"${text}#{sum(text.encode()) % 256:02x}".encode())

    def receive(self):
        while self._next() != b"$":
            pass
        text = b""
        while (byte := self._next()) != b"#":
            text += byte
        self._next(), self._next()
        self.end.sendall(b"+")
        return text.decode()

    def ask(self, text, expected=None):
        self.send(text)
        answer = self.receive()
        if expected is not None and answer != expected:
            raise zynqmp_machine.BadRun(f"the emulator's debugger port: {text.split(',')[0]}: {answer}, expected {expected}")
        return answer

    def run_to(self, address):
        """Runs all processors until one is at this address."""
        place = f"0,{address & ~1:x},2"
        self.ask(f"Z{place}", "OK")
        self.send("c")
        stopped = self.receive()
        if not stopped.startswith("T05"):
            raise zynqmp_machine.BadRun(f"the emulator's debugger port: stopped by {stopped}, expected a breakpoint")
        self.ask(f"z{place}", "OK")

    def write(self, address, data):
        self.ask(f"M{address:x},{len(data):x}:{data.hex()}", "OK")

    def read(self, address, count):
        return bytes.fromhex(self.ask(f"m{address:x},{count:x}"))

    def go(self):
        self.send("c")
