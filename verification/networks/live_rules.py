"""Rules about time: what runs and should not is stopped (4), and who is healthy runs in the end (5)."""
import re

import bounds
import frames as wire
from draw import NMT_WORDS
from safety_rules import Violation

WORDS = {value: word for word, value in NMT_WORDS.items()}
# 1F82h (semantics of CiA 302-2): what is written there is a command.
STATE_WORDS = {4: "stop", 5: "start", 6: "reset", 7: "reset-comm", 127: "preop"}
HOLDS = ("stop", "preop")
# Options of the EL6751 profile with which a slave, or all, stay stopped until somebody starts them.
BY_HAND = {"restart", "reaction", "network_reaction"}
WAITING_US = 50000  # Longer than any command waits in the manager's queue without an inhibit time.
BOOTING_STEPS = ("reset", "device type", "vendor-ID", "product code", "revision", "serial number", "state check",
                 "configuration date", "restore", "configure", "error control", "safety")
BOOTING_CODES = {"el6751": (8,), "plc_designer": (1, 2, 3)}


def starts(plan):
    """Whether the manager starts slaves by itself: 1F80h bit 3; bit 1 is with its own start, which bit 2 forbids."""
    return not plan.start_up & 0x08 and not (plan.profile == "cia302" and plan.start_up & 0x06 == 0x06)


class StopRule:
    """Rule 4: a safety slave that begins to run with another configuration, heard by the manager, is stopped in time."""

    def __init__(self, world):
        self.world = world
        self.found = []
        self.due = {}  # Node -> until when.
        self.stopped = 0

    def after(self, was_running):
        """Behind each frame; `was_running` is what was true before it."""
        world = self.world
        for number, node in world.nodes.items():
            is_wrong = node.altered_us is not None and node.safety and not node.is_double and not node.is_silent
            if node.is_running and not was_running[number] and is_wrong:
                self.due.setdefault(number, world.now_us + bounds.stop_us(world.plan, number))
            elif not node.is_running or node.altered_us is None or not node.is_there or node.is_silent or world.is_deaf:
                self.stopped += 1 if number in self.due and not node.is_running else 0
                self.due.pop(number, None)
            elif number in self.due and world.now_us > self.due[number]:
                self.found.append(Violation("4 stopped", world.now_us, f"node {number} runs with another safety "
                                            f"configuration, not stopped by {self.due.pop(number)} us"))


class Wishes:
    """Who has to run in the end, by what was commanded; what the texts leave to the application makes a slave uncertain."""

    def __init__(self, plan, events):
        self.plan = plan
        self.refused = {(event["t_us"], event["order"]) for event in events
                        if event["event"] == "order" and not event["answer"].startswith("taken")}
        # Of an order for all the answer names those who did not take it.
        self.left_out = {(event["t_us"], int(node)) for event in events if event["event"] == "order"
                         for node in re.findall(r"\bnode (\d+)", event["answer"])}
        self.now_us = 0
        self.waiting_us = WAITING_US + bounds.queue_us(plan)
        self.held_us = {}  # When the last command that holds it was given.
        self.held = dict.fromkeys((slave.node for slave in plan.slaves), False)  # By an order of the manager.
        self.halted = dict(self.held)  # By anybody's command.
        self.unsure = {slave.node: "" for slave in plan.slaves}
        self.start_up = plan.start_up
        has_events = bool(plan.events)
        for slave in plan.slaves:
            entry = slave.entry
            is_optional = entry.get("mandatory") is False
            is_by_hand = any(BY_HAND & set(each.entry.get("el6751", {})) for each in plan.slaves)
            if entry.get("boot") is False or entry.get("el6751", {}).get("start") is False or not starts(plan):
                self.unsure[slave.node] = "not to be started"
            elif has_events and is_by_hand:
                self.unsure[slave.node] = "restarted by hand"
            elif is_optional and plan.profile == "plc_designer" and (has_events or slave.comes_us > 0):
                self.unsure[slave.node] = "may be in 97"
            elif self.start_up & 0x40:
                self.unsure[slave.node] = "all stopped by error handling"
        for event in plan.events:
            self.take(event)

    def take(self, event):
        kind = event["do"]
        self.now_us = event["at_us"]
        if kind in ("insert", "reset", "replace") and self.plan.profile == "cia302":
            # A command that waits for the inhibit time may come behind it.
            self.halted[event["node"]] = self.now_us - self.held_us.get(event["node"], -self.waiting_us) < self.waiting_us
        elif kind == "duplicate":
            self.unsure[event["node"]] = "suspected duplicate"
        elif kind == "send" and event["identifier"] == wire.NMT:
            self.command(WORDS[event["data"][0]], event["data"][1], True)
        elif kind == "order" and (self.now_us, event["order"]) not in self.refused:
            self.order(event["order"].split())
        elif kind in ("bus_off", "no_controller"):
            self.deaf(event["until_us"] - event["at_us"])

    def deaf(self, for_us):
        """The boot-up message of an optional slave, or of one that nobody watches, may be lost; 99 is left by hand."""
        for slave in self.plan.slaves:
            if self.plan.profile == "plc_designer" and 2 * for_us > bounds.supervision_us(slave):
                self.unsure[slave.node] = self.unsure[slave.node] or "may be in 99"
            if slave.entry.get("mandatory") is False or slave.entry.get("heartbeat") == "0 ms":
                self.unsure[slave.node] = self.unsure[slave.node] or "its boot-up message may be lost"

    def order(self, words):
        if words[0] == "set" and words[1].startswith("0x1F80"):
            self.everybody("1F80h was changed")
        elif words[0] == "set":
            self.command(STATE_WORDS[int(words[2])], int(words[1].split(":")[1], 16))
        elif words[0] in ("control", "write-safety"):
            self.unsure[int(words[1])] = "by hand"
        else:
            self.command(words[0], 0 if words[1] == "all" else int(words[1]))

    def command(self, word, whom, is_foreign=False):
        if whom == 0 and word in HOLDS and self.plan.profile == "cia302":
            self.everybody("the manager itself was commanded")
        for node in self.held:
            # Only orders free whom an order holds; whom somebody else halted, with cia302 a boot that begins anew.
            is_nothing = word not in HOLDS and is_foreign and (word == "start" or self.plan.profile != "cia302")
            is_left_out = not is_foreign and whom == 0 and (self.now_us, node) in self.left_out
            if whom in (0, node) and not is_nothing and not is_left_out:
                self.halted[node] = word in HOLDS
                self.held[node] = self.held[node] if is_foreign else word in HOLDS
                if word in HOLDS:
                    self.held_us[node] = self.now_us

    def everybody(self, why):
        for node in self.unsure:
            self.unsure[node] = self.unsure[node] or why

    def why_not(self, node, world):
        """Why this slave need not run; empty: it has to."""
        state = world.nodes[node]
        reasons = ((not state.is_there, "absent"), (state.strange(self.plan.profile) is not None, "another device"),
                   (state.altered_us is not None or state.may_be_altered, "another safety configuration"), (self.held[node] or self.halted[node], "held"),
                   (state.is_silent, "without heartbeat"))
        return self.unsure[node] or next((word for holds, word in reasons if holds), "")

    def may_stay(self, node):
        """Whether a command, or the manager's error handling, may leave a slave in the middle of its start-up."""
        return self.held[node] or self.halted[node] or bool(self.start_up & 0x40)

    def reasons(self, world):
        """Node -> why it need not run, empty for those that have to."""
        why = {node: self.why_not(node, world) for node in self.held}
        waits = self.start_up & 0x02 and any(why[slave.node] and slave.entry.get("mandatory") is not False
                                             for slave in self.plan.slaves)
        return {node: text or ("start of all waits" if waits else "") for node, text in why.items()}


def is_booting(profile, status):
    """Whether this status is one in which a start-up goes on by itself."""
    if profile == "cia302":
        return status["letter"] in ("", "none") and status["step"] in BOOTING_STEPS
    return status["code"] in BOOTING_CODES[profile]


def rest_violations(world, states, events, wishes):
    """Rule 5: `states` of the devices themselves at the end, `events` of the manager."""
    plan, why, found = world.plan, wishes.reasons(world), []
    rested_us = plan.duration_us - plan.last_us
    statuses = {event["node"]: event for event in events if event["event"] == "status"}
    for node, state in states.items():
        status = statuses.get(node)
        if not why[node] and state != "operational":
            found.append(Violation("5 runs", plan.duration_us, f"node {node} is {state} {rested_us} us after the last "
                                                               "fault, expected operational"))
        is_one = state != "absent" and not world.nodes[node].is_double and not world.nodes[node].is_silent and not wishes.may_stay(node)
        if is_one and status is not None and is_booting(plan.profile, status):
            found.append(Violation("5 booting", plan.duration_us, f"node {node} is left at '{status['step']}', {rested_us} us "
                                                                  "after the last fault"))
    return found
