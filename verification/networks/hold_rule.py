"""Rule 7: who was told to stop by an order that was taken is not started before an order frees it (docs/manager.md)."""
import re

import frames as wire
from live_rules import HOLDS, STATE_WORDS
from safety_rules import Violation

FREES = ("start", "boot", "reset", "reset-comm", "control")
LEFT_OUT = re.compile(r"\bnode (\d+)")
TAKEN_TOO = re.compile("; (started all the same|nothing is heard of)")  # Behind them are slaves that took the order.


def meant(order):
    """Word and node (0: all) of an order."""
    words = order.split()
    if words[0] == "set" and words[1].startswith("0x1F82"):
        return STATE_WORDS[int(words[2])], int(words[1].split(":")[1], 16)
    if words[0] in HOLDS + FREES:
        return words[0], 0 if words[1] == "all" else int(words[1])
    return words[0], None


class HoldRule:
    """Judged at each NMT start of the manager, by the orders that it took before."""

    def __init__(self, world, events):
        self.world = world
        self.orders = sorted((event for event in events if event["event"] == "order" and
                              event["answer"].startswith("taken")), key=lambda event: event["t_us"])
        self.held = {}  # Node -> the order that holds it.
        self.taken = 0
        self.found = []

    def before(self, frame, is_foreign):
        """A frame that the world does not know yet."""
        while self.orders and self.orders[0]["t_us"] <= frame.t_us:
            self._take(self.orders.pop(0))
        if not frame.is_nmt or is_foreign or frame.data[0] != wire.START:
            return
        for node, order in self.held.items():
            # What the controller had already taken leaves behind the order.
            is_behind = frame.t_us - order["t_us"] > self.world.grace_us
            if frame.data[1] in (0, node) and is_behind:
                self.found.append(Violation("7 held", frame.t_us, f"start of node {frame.data[1]}, and node {node} is held "
                                            f"by '{order['order']}' since {order['t_us']} us"))

    def _take(self, order):
        word, whom = meant(order["order"])
        out = {int(node) for node in LEFT_OUT.findall(TAKEN_TOO.split(order["answer"])[0])}
        for node in self.world.nodes:
            if whom not in (0, node) or whom == 0 and node in out:
                continue
            if word in HOLDS:
                self.held[node] = order
                self.taken += 1
            elif word in FREES:
                self.held.pop(node, None)
