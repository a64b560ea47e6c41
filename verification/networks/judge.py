"""Runs one drawn network with the product, and judges what came of it."""
import collections
import json
import re
import subprocess

import frames as wire
import hold_rule
import live_rules
import safety_rules
import scenario
from safety_rules import Violation
from world import World

WANTED = re.compile(r"device of node (\d+) is ")
TIME_LIMIT_S = 1800


class Outcome:
    """What one network came to."""

    def __init__(self, plan):
        self.plan = plan
        self.violations = []
        self.counts = collections.Counter()

    def broken(self, rule, text):
        self.violations.append(Violation(rule, 0, text))


def simulate(program, path, folder):
    """Runs the product. Returns exit status, its last words, and its two files as bytes, or None."""
    log, table = folder / "frames.log", folder / "events.json"
    for file in (log, table):
        file.unlink(missing_ok=True)
    command = [str(program), "simulate", "--quiet", str(path), "--candump", str(log), "--json", str(table)]
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=TIME_LIMIT_S)
    except subprocess.TimeoutExpired:
        return None, f"no end after {TIME_LIMIT_S} s", None
    words = (done.stderr or done.stdout).strip().splitlines()
    files = (log.read_bytes(), table.read_bytes()) if log.exists() and table.exists() else None
    return done.returncode, words[-1] if words else "no text", files


def states_of(verdicts):
    """Node -> the device's own state at the end, out of what was expected of it and found; a store that was refused tells no state."""
    wanted = [(WANTED.search(verdict["wanted"]), verdict["seen"]) for verdict in verdicts]
    return {int(match.group(1)): seen for match, seen in wanted if match}


def judge(plan, catalogue, frames, document):
    """All rules about the manager over one run."""
    outcome = Outcome(plan)
    world = World(plan, catalogue)
    safety, stops = safety_rules.SafetyRules(world), live_rules.StopRule(world)
    events = document["managers"][0]["events"]
    holds = hold_rule.HoldRule(world, events)
    for _, is_frame, _, what in world.steps(frames):
        if is_frame:
            world.now_us = what.t_us
            is_foreign = what.is_nmt and world.is_foreign(what)
            safety.before(what, is_foreign)
            holds.before(what, is_foreign)
            was_running = {number: node.is_running for number, node in world.nodes.items()}
            world.hear(what)
            stops.after(was_running)
        else:
            world.act(what)
    states = states_of(document["expectations"])
    wishes = live_rules.Wishes(plan, events)
    outcome.violations = safety.found + stops.found + holds.found + live_rules.rest_violations(world, states, events, wishes)
    count(outcome, states, wishes.reasons(world), events)
    outcome.counts.update({"orders that hold a slave": holds.taken, "starts of safety slaves": safety.starts, "wrong ones that ran and were stopped": stops.stopped,
                           "frames": len(frames)})
    return outcome


def count(outcome, states, why, events):
    counts = outcome.counts
    counts["networks"] += 1
    counts[f"profile {outcome.plan.profile}"] += 1
    counts["networks with safety slaves"] += 1 if outcome.plan.safety_nodes else 0
    counts["safety slaves"] += len(outcome.plan.safety_nodes)
    counts["slaves"] += len(outcome.plan.slaves)
    for event in outcome.plan.events:
        word = event["order"].split()[0] if event["do"] == "order" else None
        counts[f"fault {event['do']}" + (f" {word}" if word else "")] += 1
    for event in events:
        is_refusal = event["event"] == "gate" and event["state"] in ("differs", "failed")
        counts["verifications refused"] += 1 if is_refusal else 0
        counts["orders refused"] += 1 if event["event"] == "order" and not event["answer"].startswith("taken") else 0
    for slave in outcome.plan.slaves:
        counts[f"in the end {states.get(slave.node, 'absent')}"] += 1
        counts[f"has to run: {why[slave.node] or 'yes'}"] += 1


def run_network(program, catalogue, plan, folder, is_run_twice):
    """Files, run and judgement of one plan."""
    path = scenario.write(plan, catalogue, folder)
    status, words, files = simulate(program, path, folder)
    if status not in (0, 1) or files is None:
        outcome = Outcome(plan)
        outcome.broken("6 program", f"exit status {status}, expected 0 or 1: {words}")
        return outcome
    document = json.loads(files[1])
    outcome = judge(plan, catalogue, wire.frames_of(files[0].decode("ascii"), folder / "frames.log"), document)
    expected = 0 if all(verdict["holds"] for verdict in document["expectations"]) else 1
    if status != expected:
        outcome.broken("6 program", f"exit status {status}, expected {expected}")
    if is_run_twice:
        outcome.counts["run twice"] += 1
        compare(outcome, files, simulate(program, path, folder)[2])
    return outcome


def compare(outcome, first, second):
    if first != second:
        outcome.broken("6 same bytes", "a second run of the same files gave other frames or events")
