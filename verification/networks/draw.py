"""Draws one network and what happens to it, all from one seed."""
import dataclasses
import random

PROFILES = ("cia302", "el6751", "plc_designer")
MANAGER = 127
MS = 1000
SECOND = 1000000
INHIBITS = ("5 ms", "20 ms", "50 ms", "100 ms")
BITRATES = (125000, 250000, 500000, 1000000)
# What is written into a safety slave by nobody on the bus; never what the DCF has.
STORES = (((0x1301, 2), 77), ((0x1301, 3), 19), ((0x13FE, 0), 0), ((0x13FF, 1), 1))
OTHER_TYPE = 0x000401A5  # 1000h of no device that is drawn.
NMT_WORDS = {"start": 1, "stop": 2, "preop": 0x80, "reset": 0x81, "reset-comm": 0x82}


@dataclasses.dataclass
class Slave:
    """A slave as the network file has it, and the device that is there at first."""

    node: int
    kind: str
    serial: int
    is_safety: bool
    entry: dict
    device_kind: str = ""
    device_serial: int = 0
    is_there: bool = True
    comes_us: int = 0
    expects_serial: bool = True


@dataclasses.dataclass
class Plan:
    """A drawn network: what its files say."""

    number: int
    profile: str
    bitrate: int
    start_up: int
    manager: dict
    slaves: list
    events: list
    last_us: int = 0
    duration_us: int = 0

    def slave(self, node):
        return next((slave for slave in self.slaves if slave.node == node), None)

    @property
    def safety_nodes(self):
        return [slave.node for slave in self.slaves if slave.is_safety]


def draw_start_up(rng, profile):
    bits = {"cia302": ((0x02, 0.25), (0x04, 0.2), (0x08, 0.05), (0x10, 0.2), (0x40, 0.1)),
            "el6751": (), "plc_designer": ((0x02, 0.3), (0x08, 0.06))}[profile]
    return 1 | sum(bit for bit, chance in bits if rng.random() < chance)


def draw_entry(rng, plan, kind, safe):
    """What the network file says of a slave besides node, DCF and serial number."""
    entry = {}
    if kind == "guarded":
        entry.update({"guard_time": f"{rng.choice((50, 100, 200))} ms", "retry_factor": rng.choice((2, 3, 5))})
    elif rng.random() < 0.12:
        entry["heartbeat"] = "0 ms"
    elif rng.random() < 0.3:
        entry.update({"heartbeat": "50 ms", "consumer": "150 ms"})
    if rng.random() < 0.25:
        entry["mandatory"] = False
    if plan.profile == "cia302" and rng.random() < 0.12 and "heartbeat" not in entry:
        entry["keep_alive"] = True
    if plan.profile == "cia302" and rng.random() < 0.06:
        entry["boot"] = False
    if safe and rng.random() < 0.3:
        entry["write_safety"] = True
    if rng.random() < 0.2:
        entry["arming"] = rng.choice(("boot_up", "first_heartbeat"))
    if plan.profile == "el6751":
        entry["el6751"] = {} if kind == "io" else {"write_sync_period": False}
        if rng.random() < 0.12:
            entry["el6751"].update(rng.choice(({"restart": "by_hand"}, {"reaction": "none"},
                                               {"network_reaction": "stop_all"}, {"start": False})))
    if plan.profile == "plc_designer" and rng.random() < 0.3:
        entry["plc_designer"] = {"reset_node": True}
    return entry


def draw_slave(rng, plan, used, wants_safety, kinds):
    node = rng.choice([node for node in range(1, 127) if node not in used])
    once = [name for name in ("sensor", "controller") if name not in kinds]
    kind = rng.choice(["relay"] * 3 + once) if wants_safety else rng.choice(("io", "io", "guarded"))
    serial = rng.randrange(1, 1000)
    slave = Slave(node, kind, serial, wants_safety, draw_entry(rng, plan, kind, wants_safety), kind, serial)
    if rng.random() < 0.08:
        slave.device_serial = serial + 5000
    if kind == "relay" and rng.random() < 0.1:
        slave.device_kind = "other relay"
    if rng.random() < 0.06:
        slave.is_there = False
    elif rng.random() < 0.12:
        slave.comes_us = rng.randrange(0, 3000) * MS
    slave.expects_serial = rng.random() < 0.9
    if rng.random() < 0.05:
        slave.entry["device_type"] = OTHER_TYPE
    return slave


def draw_slaves(rng, plan):
    has_safety = rng.random() < 0.8
    for place in range(rng.choice((1, 2, 2, 3, 3, 4, 5, 6))):
        wants_safety = has_safety and (place == 0 or rng.random() < 0.6)
        used = {MANAGER} | {slave.node for slave in plan.slaves}
        plan.slaves.append(draw_slave(rng, plan, used, wants_safety, [slave.kind for slave in plan.slaves]))
    plan.slaves.sort(key=lambda slave: slave.node)


def draw_times(rng, count):
    """Instants in order: some apart, some in the middle of what the one before began."""
    now, times = rng.choice((20, 300, 1500)) * MS, []
    for _ in range(count):
        now += rng.choice((rng.randrange(0, 5 * MS), rng.randrange(5 * MS, 60 * MS), rng.randrange(60 * MS, 600 * MS),
                           rng.randrange(600 * MS, 2000 * MS)))
        times.append(now)
    return times


class Drawer:
    """Draws events one after the other, and knows which devices are there."""

    def __init__(self, rng, plan):
        self.rng = rng
        self.plan = plan
        self.there = {slave.node: slave.is_there for slave in plan.slaves}
        self.free_us = 0  # From when on the manager's controller may fail again.

    def nodes(self, at_us, is_there):
        """Devices that have come, and are there or not."""
        return [slave.node for slave in self.plan.slaves
                if slave.is_there and slave.comes_us <= at_us and self.there[slave.node] == is_there]

    def event(self, at_us):
        kinds = [(self.pull, 2), (self.insert, 6), (self.reset, 3), (self.replace, 4), (self.store, 4), (self.silence, 1),
                 (self.duplicate, 1), (self.tamper, 4), (self.nmt, 4), (self.order, 6), (self.bus_off, 3), (self.storm, 1),
                 (self.babble, 1)]
        while True:
            draw = self.rng.choices([kind for kind, _ in kinds], [weight for _, weight in kinds])[0]
            event = draw(at_us)
            if event is not None:
                steps = event if isinstance(event, list) else [event]
                return [{"at_us": at_us + step.pop("after_us", 0), **step} for step in steps]

    def _one(self, at_us, is_there=True):
        nodes = self.nodes(at_us, is_there)
        return self.rng.choice(nodes) if nodes else None

    def pull(self, at_us):
        node = self._one(at_us)
        if node is not None:
            self.there[node] = False
        return None if node is None else {"do": "pull", "node": node}

    def insert(self, at_us):
        node = self._one(at_us, False)
        if node is not None:
            self.there[node] = True
        return None if node is None else {"do": "insert", "node": node}

    def reset(self, at_us):
        node = self._one(at_us)
        return None if node is None else {"do": "reset", "node": node}

    def replace(self, at_us):
        node = self._one(at_us, self.rng.random() < 0.7)
        if node is None:
            return None
        self.there[node] = True
        serial = self.plan.slave(node).serial + (0 if self.rng.random() < 0.4 else 7000)
        return {"do": "replace", "node": node, "serial": serial}

    def store(self, at_us):
        nodes = [node for node in self.nodes(at_us, True) if self.plan.slave(node).is_safety]
        if not nodes:
            return None
        key, value = self.rng.choice(STORES)
        return {"do": "store", "node": self.rng.choice(nodes), "key": key, "value": value}

    def tamper(self, at_us):
        """Somebody takes a safety slave out of OPERATIONAL, writes into it, and starts it again, or has it started."""
        store = self.store(at_us)
        if store is None:
            return None
        node, gap_us = store["node"], self.rng.choice((2, 20, 150)) * MS
        out = self.rng.choice(({"do": "order", "order": f"preop {node}"},
                               {"do": "send", "identifier": 0, "data": bytes((0x80, node))}))
        back = self.rng.choice(({"do": "order", "order": f"start {node}"}, {"do": "order", "order": "start all"},
                                {"do": "send", "identifier": 0, "data": bytes((1, node))},
                                {"do": "send", "identifier": 0, "data": bytes((1, 0))}))
        return [out, {"after_us": gap_us, **store}, {"after_us": 2 * gap_us, **back}]

    def silence(self, at_us):
        nodes = [node for node in self.nodes(at_us, True) if self.plan.slave(node).kind != "guarded"]
        return {"do": "store", "node": self.rng.choice(nodes), "key": (0x1017, 0), "value": 0} if nodes else None

    def duplicate(self, at_us):
        node = self._one(at_us)
        return None if node is None else {"do": "duplicate", "node": node}

    def nmt(self, _at_us):
        word = self.rng.choice(list(NMT_WORDS))
        node = self.rng.choice([0] + [slave.node for slave in self.plan.slaves] * 2)
        return {"do": "send", "identifier": 0, "data": bytes((NMT_WORDS[word], node))}

    def order(self, _at_us):
        node = self.rng.choice([slave.node for slave in self.plan.slaves])
        words = [f"{word} {whom}" for word in NMT_WORDS for whom in (node, node, "all")]
        words += [f"boot {node}"] * 4
        if self.plan.slave(node).is_safety:
            words += [f"write-safety {node}"] * 2
        if self.plan.profile == "el6751":
            words += [f"control {node} {a} {d}" for a, d in ((5, 0), (5, 1), (6, 0), (5, 3), (5, 2))]
        if self.plan.profile == "cia302":
            words += [f"set 0x1F80:00 {self.plan.start_up ^ bit}" for bit in (2, 8)]
        words += [f"set 0x1F82:{node:02X} {value}" for value in (4, 5, 6, 7, 127)]
        return {"do": "order", "order": self.rng.choice(words)}

    def bus_off(self, at_us):
        if at_us < self.free_us:
            return None
        until = at_us + self.rng.choice((3, 30, 120, 700, 1500)) * MS + self.rng.randrange(0, MS)
        self.free_us = until + MS
        return {"do": self.rng.choice(("bus_off", "bus_off", "no_controller")), "until_us": until}

    def storm(self, at_us):
        node = self.rng.choice([slave.node for slave in self.plan.slaves])
        return {"do": "emcy_storm", "node": node, "every_us": 2000, "until_us": at_us + self.rng.randrange(50, 800) * MS}

    def babble(self, at_us):
        identifier = self.rng.choice((0x001, 0x0FF, 0x57F, 0x7FF))
        return {"do": "babble", "identifier": identifier, "every_us": 2000,
                "until_us": at_us + self.rng.randrange(50, 800) * MS}


def possible(plan):
    """The events in their order, without those of a device that has gone meanwhile."""
    there = {slave.node: slave.is_there for slave in plan.slaves}
    events = []
    for event in sorted(plan.events, key=lambda each: each["at_us"]):
        kind, node = event["do"], event.get("node")
        if kind in ("pull", "reset", "store", "duplicate") and not there[node] or kind == "insert" and there[node]:
            continue
        if kind in ("pull", "insert", "replace"):
            there[node] = kind != "pull"
        events.append(event)
    return events


def draw(seed, number, rest_us):
    """Network `number` of the seed; `rest_us` tells of a plan how long it may take to come to rest."""
    rng = random.Random(f"{seed}/{number}")
    profile = rng.choice(PROFILES)
    plan = Plan(number, profile, rng.choice(BITRATES), draw_start_up(rng, profile), {}, [], [])
    plan.manager = {"node": MANAGER, "profile": profile, "heartbeat": "200 ms", "start_up": plan.start_up}
    if profile == "el6751":
        plan.manager["sync"] = "20 ms"
        plan.manager["heartbeat"] = "50 ms"
        plan.manager["el6751"] = {"input_shift": "8 ms"}
    if profile == "cia302" and rng.random() < 0.5:
        plan.manager["boot_time"] = f"{rng.choice((500, 2000, 5000))} ms"
    chance = rng.random()
    if chance < 0.2:
        plan.manager["inhibit"] = INHIBITS[int(chance * 5 * len(INHIBITS))]
    draw_slaves(rng, plan)
    drawer = Drawer(rng, plan)
    for at_us in draw_times(rng, rng.randrange(0, 9)):
        plan.events += drawer.event(at_us)
    plan.events = possible(plan)
    plan.last_us = max([0] + [event.get("until_us", event["at_us"]) for event in plan.events]
                       + [slave.comes_us for slave in plan.slaves])
    plan.duration_us = plan.last_us + rest_us(plan)
    return plan
