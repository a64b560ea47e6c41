#!/usr/bin/env python3
"""Draws networks with faults, runs them with `counterpoint simulate`, and judges what the manager did.

    python3 verification/networks/run.py --program build/product/tools/counterpoint --runs 1000 --seed 1
    python3 verification/networks/run.py --program ... --seed 1 --first 17 --runs 1 --keep /tmp/network
    python3 verification/networks/run.py --self-test

Exit status: 0 every rule holds in every network; 1 one does not; 2 bad input.
"""
import argparse
import collections
import json
import pathlib
import re
import subprocess
import sys
import tempfile

import bounds
import devices
import draw
import frames as wire
import live_rules
import safety_rules
import scenario
from world import World

VERDICT = re.compile(r"state of (?:device|node) (\d+).* is ([a-z-]+)")


class BadInput(Exception):
    """Arguments that cannot be used."""


class Outcome:
    """What one network came to."""

    def __init__(self, plan):
        self.plan = plan
        self.violations = []
        self.starts = 0
        self.stopped = 0
        self.states = {}
        self.why = {}
        self.events = []


def simulate(program, path, folder):
    """Runs the product; events, frames and verdicts as they are in its files."""
    log, table = folder / "frames.log", folder / "events.json"
    done = subprocess.run([str(program), "simulate", "--quiet", str(path), "--candump", str(log), "--json", str(table)],
                          capture_output=True, text=True, check=False)
    return done, log, table


def states_of(verdicts):
    states = {}
    for verdict in verdicts:
        found = VERDICT.search(verdict["text"])
        states[int(found.group(1))] = found.group(2)
    return states


def judge(plan, catalogue, frames, document, outcome):
    """All rules over one run."""
    world = World(plan, catalogue)
    safety, stops = safety_rules.SafetyRules(world), live_rules.StopRule(world)
    for _, is_frame, _, what in world.steps(frames):
        if not is_frame:
            world.act(what)
            continue
        world.now_us = what.t_us
        safety.before(what, what.is_nmt and world.is_foreign(what))
        was_running = {number: node.is_running for number, node in world.nodes.items()}
        world.hear(what)
        stops.after(was_running)
    outcome.states = states_of(document["verdicts"])
    outcome.events = document["managers"][0]["events"]
    outcome.why = live_rules.Wishes(plan).musts(world)
    outcome.starts, outcome.stopped = safety.starts, stops.stopped
    outcome.violations += safety.found + stops.found
    outcome.violations += live_rules.rest_violations(world, outcome.states, outcome.events, outcome.why)


def run_network(program, catalogue, plan, folder, checks_twice):
    outcome = Outcome(plan)
    path = scenario.write(plan, catalogue, folder)
    done, log, table = simulate(program, path, folder)
    if done.returncode not in (0, 1) or not table.exists():
        text = (done.stderr or done.stdout).strip().splitlines()
        outcome.violations.append(safety_rules.Violation("6 program", 0, f"exit status {done.returncode}, "
                                                         f"{text[-1] if text else 'no text'}"))
        return outcome
    document = json.loads(table.read_text(encoding="utf-8"))
    expected = 0 if all(verdict["holds"] for verdict in document["verdicts"]) else 1
    if done.returncode != expected:
        outcome.violations.append(safety_rules.Violation("6 program", 0, f"exit status {done.returncode}, expected {expected}"))
    judge(plan, catalogue, wire.read_frames(log), document, outcome)
    if checks_twice:
        before = log.read_bytes(), table.read_bytes()
        simulate(program, path, folder)
        if before != (log.read_bytes(), table.read_bytes()):
            outcome.violations.append(safety_rules.Violation("6 same bytes", 0, "a second run gave other bytes"))
    return outcome


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", type=pathlib.Path)
    parser.add_argument("--runs", type=int, default=100)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", type=pathlib.Path)
    options = parser.parse_args()
    counts = collections.Counter()
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        catalogue = devices.Catalogue(options.program, work)
        for number in range(options.first, options.first + options.runs):
            plan = draw.draw(options.seed, number, bounds.rest_us)
            place = options.keep or work / str(number)
            place.mkdir(parents=True, exist_ok=True)
            outcome = run_network(options.program, catalogue, plan, place, number % 10 == 0)
            counts["starts"] += outcome.starts
            counts["stopped"] += outcome.stopped
            counts["slaves"] += len(plan.slaves)
            for node, why in outcome.why.items():
                counts["why: " + why] += 1
            for v in outcome.violations:
                print(f"seed {options.seed} network {number} {plan.profile} {v.t_us/1e6:.6f} s {v.rule}: {v.text}")
    for key in sorted(counts):
        print(counts[key], key)


main()
