"""Runs images on the two Cortex-R5F of the emulator's machine xlnx-zcu102 (Zynq UltraScale+).

    with Machine([image_0, image_1], argument="short", extra=[...]) as machine:
        machine.start()
        ended = machine.wait_for(0, "end=")      # text of UART 0, None: the program stopped or the last resort of time

Time is that of executed instructions (-icount): no verdict depends on how busy the host is. Each core writes to the UART of its
number; what it wrote is in machine.text[core]. The monitor powers the cores on, since the machine would leave that to its
first processors. Nothing of this is a model of ours: the controllers are the emulator's own.
"""
import json
import os
import pathlib
import select
import shutil
import socket
import subprocess
import tempfile
import time

COMMAND = ["qemu-system-aarch64", "-S", "-M", "xlnx-zcu102,secure=on", "-smp", "6", "-m", "512M", "-display", "none", "-nodefaults",
           "-global", "driver=xlnx-zynqmp,property=boot-cpu,value=rpu-cpu[0]"]
CAN_BUS = ["-object", "can-bus,id=cb", "-machine", "canbus0=cb", "-machine", "canbus1=cb"]
# One instruction is 2^shift ns; idle time costs nothing.
INSTRUCTIONS = ["-icount", "shift={shift},sleep=off"]
FIRST_CORE = 4  # Of the machine's six processors.
ARGUMENT_ADDRESS = 0xFFFDF000
LAST_RESORT_SECONDS = 300


class BadRun(Exception):
    """The emulator did not start or answered its monitor with an error."""


class Machine:
    """One run of the machine: images[0] for core 0, images[1] for core 1 (or none). An instruction takes 2^shift ns."""

    def __init__(self, images, argument="", extra=(), can=False, shift=3, files=None, gdb=False, instructions=True):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="zynqmp"))
        self.images, self.text = [str(image) for image in images], ["", ""]
        (self.folder / "argument").write_bytes(argument.encode() + b"\0")
        command = COMMAND + ([part.format(shift=shift) for part in INSTRUCTIONS] if instructions else []) + (CAN_BUS if can else []) + list(extra)
        command += ["-device", f"loader,file={self.folder}/argument,addr={ARGUMENT_ADDRESS:#x},force-raw=on"]
        for core, image in enumerate(self.images):
            command += ["-device", f"loader,file={image},cpu-num={FIRST_CORE + core}"]
        for path, address in (files or {}).items():
            command += ["-device", f"loader,file={path},addr={address:#x},force-raw=on"]
        self.listeners = {name: self._listen(name) for name in ("uart0", "uart1", "monitor", *(["gdb"] if gdb else []))}
        for name in ("uart0", "uart1"):
            command += ["-chardev", f"socket,id={name},path={self.folder}/{name}", "-serial", f"chardev:{name}"]
        command += ["-chardev", f"socket,id=monitor,path={self.folder}/monitor", "-mon", "chardev=monitor,mode=control"]
        if gdb:
            command += ["-chardev", f"socket,id=gdb,path={self.folder}/gdb", "-gdb", "chardev:gdb"]
        self.command = command
        self.process = None
        self.ends = {}
        self.answers = b""

    def _listen(self, name):
        listener = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        listener.bind(str(self.folder / name))
        listener.listen(1)
        listener.settimeout(LAST_RESORT_SECONDS)
        return listener

    def __enter__(self):
        environment = {**os.environ, "QEMU_AUDIO_DRV": "none"}
        with open(self.folder / "errors", "wb") as errors:
            self.process = subprocess.Popen(self.command, stdin=subprocess.DEVNULL, stdout=errors, stderr=errors, env=environment)
        try:
            for name, listener in self.listeners.items():
                self.ends[name] = self._accept(listener)
            self._answer()  # The greeting.
            self.monitor("qmp_capabilities")
        except BaseException:
            self.__exit__()
            raise
        return self

    def _accept(self, listener):
        while self.process.poll() is None:
            if select.select([listener], [], [], 0.2)[0]:
                return listener.accept()[0]
        raise BadRun(f"the emulator ended: {self.errors()}")

    def errors(self):
        return (self.folder / "errors").read_text(encoding="utf-8", errors="replace").strip()

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        for end in (*self.ends.values(), *self.listeners.values()):
            end.close()
        shutil.rmtree(self.folder, ignore_errors=True)

    def _answer(self):
        while True:
            while b"\n" not in self.answers:
                try:
                    got = self.ends["monitor"].recv(65536)
                except ConnectionResetError:
                    got = b""
                if not got:
                    raise BadRun(f"the emulator ended: {self.errors()}")
                self.answers += got
            line, self.answers = self.answers.split(b"\n", 1)
            answer = json.loads(line)
            if "event" not in answer:
                return answer

    def monitor(self, execute, **arguments):
        """One request to the monitor (QMP) and its answer."""
        self.ends["monitor"].sendall(json.dumps({"execute": execute, "arguments": arguments}).encode() + b"\n")
        answer = self._answer()
        if "error" in answer:
            raise BadRun(f"{execute} {arguments}: {answer['error']}")
        return answer.get("return")

    def start(self, run=True):
        """Powers on as many cores as there are images; `run`: they begin."""
        for core in range(len(self.images)):
            self.monitor("qom-set", path=f"/machine/soc/rpu-cluster/rpu-cpu[{core}]", property="start-powered-off", value=False)
        self.monitor("system_reset")
        if run:
            self.monitor("cont")

    def collect(self, seconds):
        """Takes what the UARTs have; False if nothing came for so long or the emulator ended."""
        ends = {self.ends["uart0"]: 0, self.ends["uart1"]: 1}
        ready = select.select(list(ends), [], [], seconds)[0]
        came = False
        for end in ready:
            got = end.recv(65536)
            came = came or bool(got)
            self.text[ends[end]] += got.decode("utf-8", "replace")
        return came

    def wait_for(self, core, text, times=1, seconds=LAST_RESORT_SECONDS):
        """The whole text of this core's UART once `text` and the end of its line have come so many times; None if the run ended
        before. `seconds` is a last resort against a program that hangs, not a measure."""
        until = time.monotonic() + seconds
        while True:
            if len(self.text[core].split(text)) > times and "\n" in self.text[core].split(text, times)[times]:
                return self.text[core]
            if time.monotonic() > until or not self.collect(max(0.0, until - time.monotonic())):
                return None

    def read(self, address, count):
        """Bytes of the machine's memory, while it runs or stands."""
        path = self.folder / "memory"
        self.monitor("pmemsave", val=address, size=count, filename=str(path))
        return path.read_bytes()


def run(images, argument="", extra=(), can=False, shift=3, files=None, instructions=True):
    """Runs until every core told its end; (texts of the UARTs, exit status of the program or None). `instructions`: time is that of
    instructions; a program that asks for no time runs faster without."""
    with Machine(images, argument, extra, can, shift, files, instructions=instructions) as machine:
        machine.start()
        texts = [machine.wait_for(core, "end=") for core in range(len(images))]
        statuses = [text.rsplit("end=", 1)[1].split("\n")[0] if text else None for text in texts]
        status = None if None in statuses else max(int(status) for status in statuses)
        return machine.text, status
