"""What is true of a simulated network at each instant: from its files, its events and the frames of its bus alone."""
import dataclasses
import heapq

import frames as wire

SAFETY_OBJECTS = range(0x1300, 0x1400)
FRAME_BITS = 160  # The longest one with stuffing and intermission, rounded up.
CYCLE_US = 1000
STALE_US = 20000  # So long a sign of life behind a command may have been on its way before it.


@dataclasses.dataclass
class Reading:
    """What the manager has read of a safety slave since something ended what it knew."""

    values: dict = dataclasses.field(default_factory=dict)
    ended_us: int = 0

    def take(self, transfer):
        self.values[transfer.key] = transfer


class Node:
    """One slave: the device that is there, and what the manager could hear of it."""

    def __init__(self, slave, expected, device):
        self.slave = slave
        self.safety = expected.safety
        self.expected = expected.identity(slave.serial if slave.expects_serial else None)
        self.expected[(0x1000, 0)] = slave.entry.get("device_type", self.expected[(0x1000, 0)])
        self.device = device
        self.serial = slave.device_serial
        self.is_there = slave.is_there
        self.is_double = False
        self.has_other_dcf = slave.device_kind != slave.kind
        self.altered_us = 0 if self.has_other_dcf else None  # Its safety configuration is another one since then.
        self.may_be_altered = False  # Somebody wrote into it while it ran, which a device refuses.
        self.is_silent = False  # Somebody took its heartbeat away.
        self.exchanged_us = None  # Another device took its place then, and nobody has heard its boot-up message.
        self.was_deaf = False  # That boot-up message came while the manager heard nothing.
        self.is_running = False
        self.commanded_us = -STALE_US  # The last NMT command.
        self.reading = Reading()
        self.before = Reading()  # What was known until the last end of knowledge.

    def strange(self, profile):
        """The object by which the device that is there is another one than the expected one; None: it is that one."""
        real = self.device.identity(self.serial)
        is_plc = profile == "plc_designer"
        mask = 0xFFFF if is_plc else 0xFFFFFFFF
        for key, value in self.expected.items():
            is_compared = value and (not is_plc or key == (0x1000, 0))
            if is_compared and value & mask != real[key] & mask:
                return key
        return None

    def forget(self, now_us):
        """What was read counts no more."""
        self.before, self.reading = self.reading, Reading()
        self.reading.ended_us = now_us

    def begin_anew(self, now_us):
        """The device has the values of its DCF again."""
        self.altered_us = now_us if self.has_other_dcf else None
        self.may_be_altered = False
        self.is_silent = False
        self.is_running = False

    def missing(self, now_us, grace_us):
        """The first object that was not read as expected before a start at `now_us`; None: all were."""
        reading = self.before if now_us - self.reading.ended_us <= grace_us else self.reading
        last_us = 0
        for key, (value, size) in self.safety.items():
            transfer = reading.values.get(key)
            if transfer is None or transfer.is_abort or (transfer.value, transfer.size) != (value, size):
                return key
            last_us = max(last_us, transfer.asked_us if key != (0x13FE, 0) else 0)
        return (0x13FE, 0) if reading.values[(0x13FE, 0)].asked_us < last_us else None


class World:
    """Goes through events and frames in their order; rules ask it."""

    def __init__(self, plan, catalogue):
        self.plan = plan
        self.nodes = {slave.node: Node(slave, catalogue.of(slave.kind, slave.node),
                                       catalogue.of(slave.device_kind, slave.node)) for slave in plan.slaves}
        self.frame_us = FRAME_BITS * 1000000 // plan.bitrate
        self.grace_us = 3 * self.frame_us + CYCLE_US
        self.foreign = []  # NMT frames of somebody else that are not on the bus yet.
        self.deaf_until_us = 0
        self.ear = wire.SdoEar()
        self.now_us = 0

    @property
    def is_deaf(self):
        return self.now_us < self.deaf_until_us

    def steps(self, frames):
        """Events and frames by time; events first."""
        events = sorted(self.plan.events, key=lambda event: event["at_us"])
        backs = [{"do": "bus_back", "at_us": event["until_us"]} for event in events
                 if event["do"] in ("bus_off", "no_controller")]
        acts = sorted(events + backs, key=lambda event: event["at_us"])
        return heapq.merge(((event["at_us"], 0, number, event) for number, event in enumerate(acts)),
                           ((frame.t_us, 1, number, frame) for number, frame in enumerate(frames)))

    def act(self, event):
        """An event of the scenario."""
        self.now_us = event["at_us"]
        node = self.nodes.get(event.get("node"))
        kind = event["do"]
        if kind in ("bus_off", "no_controller"):
            self.deaf_until_us = event["until_us"]
        elif kind == "bus_back":
            for each in self.nodes.values():
                each.forget(self.now_us)
        elif kind == "send" and event["identifier"] == wire.NMT:
            self.foreign.append((event["at_us"], event["data"]))
        elif kind == "store" and event["key"][0] in SAFETY_OBJECTS:
            node.may_be_altered = node.may_be_altered or node.is_running
            node.altered_us = node.altered_us if node.is_running else self.now_us
        elif kind == "store":
            node.is_silent = True
        elif kind in ("pull", "insert", "reset", "replace", "duplicate"):
            self._supply(node, event)

    def _supply(self, node, event):
        kind = event["do"]
        node.is_there = kind != "pull"
        node.is_double = kind == "duplicate"
        if kind != "duplicate":
            node.begin_anew(self.now_us)
        if kind == "replace":
            node.serial = event["serial"]
            node.exchanged_us, node.was_deaf = self.now_us, False

    def is_foreign(self, frame):
        """Whether somebody else sent this NMT frame; it is taken as his no more."""
        for place, (_, data) in enumerate(self.foreign):
            if data == frame.data:
                del self.foreign[place]
                return True
        return False

    def hear(self, frame):
        """A frame of the bus, after the rules have looked at it. Returns the SDO transfer that it completes."""
        self.now_us = frame.t_us
        if frame.is_nmt:
            self._command(frame)
        elif frame.state is not None and frame.node in self.nodes:
            self._sign_of_life(self.nodes[frame.node], frame.state)
        transfer = self.ear.hear(frame)
        if transfer is not None and transfer.node in self.nodes:
            self._transfer(self.nodes[transfer.node], transfer)
        return transfer

    def _sign_of_life(self, node, state):
        is_stale = state != wire.BOOT_UP and self.now_us - node.commanded_us < STALE_US
        node.is_running = node.is_running if is_stale else state == wire.OPERATIONAL
        if state == wire.BOOT_UP:
            if not self.is_deaf:
                node.forget(self.now_us)
                node.exchanged_us = None
            elif node.exchanged_us is not None:
                node.was_deaf = True

    def _transfer(self, node, transfer):
        if transfer.key[0] not in SAFETY_OBJECTS:
            return
        if not transfer.is_write:
            if transfer.asked_us >= node.reading.ended_us:
                node.reading.take(transfer)
        elif not transfer.is_abort:
            node.reading.values.pop(transfer.key, None)
            is_declared = transfer.key == (0x13FE, 0) and transfer.value == 0xA5
            node.altered_us = None if is_declared else (node.altered_us or self.now_us)

    def _command(self, frame):
        command, whom = frame.data
        for number, node in self.nodes.items():
            if whom not in (0, number):
                continue
            node.commanded_us = self.now_us
            if command in (wire.RESET, wire.RESET_COMM):
                node.begin_anew(self.now_us)
            if command == wire.START:
                node.is_running = True
            elif command in (wire.STOP, wire.PREOP, wire.RESET, wire.RESET_COMM):
                node.is_running = False
                node.forget(self.now_us)
