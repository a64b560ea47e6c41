"""Rules about what the manager starts and writes (semantics 10)."""
import dataclasses

import frames as wire
from world import SAFETY_OBJECTS


@dataclasses.dataclass(frozen=True)
class Violation:
    """One rule that does not hold."""

    rule: str
    t_us: int
    text: str


def object_name(key):
    return f"0x{key[0]:04X}:{key[1]:02X}"


class SafetyRules:
    """Rules 1 to 3, judged at each NMT start and each write of the manager."""

    def __init__(self, world):
        self.world = world
        self.found = []
        self.starts = 0

    def tell(self, rule, text):
        self.found.append(Violation(rule, self.world.now_us, text))

    def before(self, frame, is_foreign):
        """A frame that the world does not know yet."""
        if frame.is_nmt and not is_foreign and frame.data[0] == wire.START:
            self._start(frame.data[1])
        is_request = frame.function == wire.REQUEST and len(frame.data) == 8 and not frame.is_remote
        if is_request and frame.data[0] & 0xE0 == wire.DOWNLOAD:
            self._write(frame)

    def _start(self, whom):
        world = self.world
        if whom == 0:
            if world.plan.safety_nodes:
                self.tell("1 start of all", f"start to node 0 with safety slaves {world.plan.safety_nodes}")
            return
        node = world.nodes.get(whom)
        if node is None or not node.safety:
            return
        self.starts += 1
        key = node.missing(world.now_us, world.grace_us)
        if key is not None:
            self.tell("2 verified", f"start of node {whom}, {object_name(key)} not read as expected before it")
        asked = node.reading.values.get((0x13FE, 0))
        is_other = node.altered_us is not None and not node.is_double  # Of two devices one is asked.
        if is_other and asked is not None and node.altered_us < asked.asked_us:
            self.tell("2 verified", f"start of node {whom}, whose safety configuration is another one since "
                                    f"{node.altered_us} us")
        self._identity(node, f"start of node {whom}")

    def _write(self, frame):
        index = frame.data[1] | frame.data[2] << 8
        node = self.world.nodes.get(frame.node)
        if node is not None and node.safety and index in SAFETY_OBJECTS:
            self._identity(node, f"write of {object_name((index, frame.data[3]))} to node {frame.node}")

    def _identity(self, node, what):
        world = self.world
        key = node.strange(world.plan.profile)
        if key is None:
            return
        is_unheard = node.exchanged_us is not None and not node.was_deaf
        if is_unheard:
            return  # Its boot-up message is not on the bus yet.
        where = ", exchanged while the manager heard nothing" if node.exchanged_us is not None else ""
        rule = "3 identity, exchanged unheard" if where else "3 identity"
        self.tell(rule, f"{what}, which is another device ({object_name(key)}){where}")
