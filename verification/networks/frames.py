"""What a simulated network left behind: frames of the bus (candump -l), and the SDO transfers that they are."""
import dataclasses
import re

LINE = re.compile(r"\((\d+)\.(\d{6})\) \S+ ([0-9A-F]{3})#(R\d|[0-9A-F]*)$")
NMT, EMCY, ANSWER, REQUEST, ERROR_CONTROL = 0x000, 0x080, 0x580, 0x600, 0x700
START, STOP, PREOP, RESET, RESET_COMM = 1, 2, 0x80, 0x81, 0x82
BOOT_UP, STOPPED, OPERATIONAL, PRE_OPERATIONAL = 0, 4, 5, 0x7F
UPLOAD, DOWNLOAD, ABORT = 0x40, 0x20, 0x80


class BadLog(Exception):
    """A log that cannot be read."""


@dataclasses.dataclass(frozen=True)
class Frame:
    """One frame at its end."""

    t_us: int
    identifier: int
    data: bytes
    is_remote: bool = False

    @property
    def node(self):
        return self.identifier & 0x7F

    @property
    def function(self):
        return self.identifier & ~0x7F

    @property
    def is_nmt(self):
        return self.identifier == NMT and len(self.data) == 2 and not self.is_remote

    @property
    def state(self):
        """The state in a heartbeat, boot-up message or guarding answer; None: it is none."""
        if self.function != ERROR_CONTROL or self.node == 0 or self.is_remote or len(self.data) != 1:
            return None
        return self.data[0] & 0x7F


@dataclasses.dataclass(frozen=True)
class Transfer:
    """One expedited SDO transfer that was answered; `value` of an upload is what was read."""

    asked_us: int
    answered_us: int
    node: int
    is_write: bool
    key: tuple
    value: int
    size: int
    is_abort: bool


def frames_of(text, name):
    """The frames of a log; `name` is what it is called when a line is none."""
    frames = []
    for number, line in enumerate(text.splitlines(), start=1):
        found = LINE.match(line)
        if not found:
            raise BadLog(f"{name}:{number}: '{line}', expected (SECONDS.MICROSECONDS) can0 IDENTIFIER#DATA")
        seconds, micro, identifier, data = found.groups()
        is_remote = data.startswith("R")
        frames.append(Frame(int(seconds) * 1000000 + int(micro), int(identifier, 16),
                            b"" if is_remote else bytes.fromhex(data), is_remote))
    return frames


class SdoEar:
    """Joins requests and answers; an answer that nobody asked for is none."""

    def __init__(self):
        self.open = {}

    def hear(self, frame):
        """The transfer that this frame completes, else None."""
        if frame.is_remote or len(frame.data) != 8:
            return None
        if frame.function == REQUEST:
            command = frame.data[0] & 0xE0
            if command in (UPLOAD, DOWNLOAD):
                self.open[frame.node] = frame
            elif command == ABORT:
                self.open.pop(frame.node, None)
        elif frame.function == ANSWER:
            return self._close(frame)
        return None

    def _close(self, frame):
        asked = self.open.get(frame.node)
        if asked is None or asked.data[1:4] != frame.data[1:4]:
            return None
        del self.open[frame.node]
        key = (asked.data[1] | asked.data[2] << 8, asked.data[3])
        is_write = asked.data[0] & 0xE0 == DOWNLOAD
        carrier = asked if is_write else frame
        value, size = expedited(carrier.data)
        return Transfer(asked.t_us, frame.t_us, frame.node, is_write, key, value, size, frame.data[0] == ABORT)


def expedited(data):
    """Value and bytes of an expedited transfer; (None, 0): it comes in segments."""
    if not data[0] & 0x02:
        return None, 0
    size = 4 - (data[0] >> 2 & 3) if data[0] & 1 else 4
    return int.from_bytes(data[4:4 + size], "little"), size
