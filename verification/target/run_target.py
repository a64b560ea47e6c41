#!/usr/bin/env python3
"""Runs the certified code big-endian on an emulated Cortex-R5F and compares with the host. `./dev firmware`.

    run_target.py [--tests] [--no-build]

Builds images (build/target) and the same programs for the host (build/product). Checks, one line each: the way of both
compilers into one image, faults that end a run, the conformance cases and the differential sequences (number, failures,
hash: as on the host), the network manager with a whole safety device as its slave, the firmware examples in scenarios and with
misdeeds, the images for silicon, coverage of the target's objects, symbols, both byte orders, stack; cases and sequences
little-endian on four Cortex-M; the Cortex-R5F of a Zynq UltraScale+: start-up, cases and sequences, the third voice, a device with two CPUs on both
processors and faults in one of them. Result: build/target/target.json.
  --tests     coverage with the tests of core, link and self tests and with corrupted storage, too: 360 tests on the target; then
              no condition of a decision may be left that the target does not show (some minutes more)
  --no-build  use what was built before
Exit status: 0 everything holds, 1 something does not, 2 it could not be run.
"""
import argparse
import json
import pathlib
import re
import subprocess
import sys

import application_sources
import byte_order
import cortex_m_run
import coverage_run
import driver_sources
import emulator
import firmware_run
import image_check
import image_fixtures
import manager_run
import objects
import stack
import target_build
import zynqmp_hal_run
import zynqmp_machine
import zynqmp_run

ROOT = pathlib.Path(__file__).resolve().parents[2]
HERE = pathlib.Path(__file__).resolve().parent
TARGET = ROOT / "build/target"
PRODUCT = ROOT / "build/product"
IMAGES = TARGET / "verification/target"
RUN_LINE = re.compile(r"^run=(\S+) (.*)$", re.MULTILINE)
CYCLE_LINE = re.compile(r"item=(\w+) srdos=(\d+) repetitions=(\d+) instructions=(\d+)")
ELF_FLAGS = {"be8": 0x5800400, "be32": 0x5000400}
# What a fault must print, by the argument that asks the self test for it; None: the time limit ends the run.
FAULTS = {"undefined": "FAILURE: undefined instruction at 0x", "data": "accessed 0x70000000\nFAILURE: data or prefetch abort at 0x",
          "pure": "FAILURE: pure virtual call", "hang": None}
# The rest of the facade is inline and forwards: its depth is that of what it forwards to.
STACK_ENTRIES = ["counterpoint::" + name for name in (
    "Kernel::Start(", "Kernel::OnFrame(", "Kernel::OnConfirm(", "Kernel::Cycle(", "Kernel::SetNmtState(", "Kernel::Send(",
    "Kernel::SendGfc(", "Kernel::CheckConfiguration(", "Kernel::Sign(", "Kernel::GetState(", "Kernel::GetStatus(",
    "Kernel::SetStatus(", "Kernel::GetParameters(", "Kernel::GetMapped(", "Kernel::DefineStaticFields(",
    "ConfigurationGuard::Read(", "ConfigurationGuard::Write(", "SafeStateLatch::Enter(", "SafeStateLatch::Report(")]


IMAGES_RUN = ("selftest/selftest", "conformance/conformance", "bench/bench", "manager/manager", "firmware/trap/trap",
              *(f"firmware/{device}" for device in firmware_run.DEVICES))
# What no image of the big-endian processor holds: compiled with instrumentation it runs there with the tests. [SRS_FW_010]
IN_NO_IMAGE = ("safety_core/crosslink/", "safety_core/kernel/configuration_image.cpp", "safety_core/kernel/limits.cpp")


class Report:
    """The checks in their order, and which requirements they show."""

    def __init__(self):
        self.rows = []

    def add(self, holds, text, found, *requirements):
        self.rows.append({"holds": bool(holds), "check": text, "found": found, "requirements": list(requirements)})
        print(f"{'ok  ' if holds else 'FAIL'}  {text}: {found}", flush=True)

    def requirements(self):
        result = {}
        for row in self.rows:
            for requirement in row["requirements"]:
                result[requirement] = result.get(requirement, True) and row["holds"]
        return result

    def passed(self):
        return all(row["holds"] for row in self.rows)


def check_selftest(report):
    image = IMAGES / "selftest/selftest.bin"
    run = emulator.run_image(image, "all")
    count = run.output.count("selftest: holds: ")
    report.add(run.status == 0 and count == 4, "self test of the way into an image", f"{count} of 4 hold", "SRS_TGT_001")
    for argument, expected in FAULTS.items():
        run = emulator.run_image(image, argument, 1800 if expected else 2)
        if expected is None:
            report.add(run.status is None, "an endless loop is ended by the time limit", f"exit status {run.status}", "SRS_TGT_009")
        else:
            last = (run.output.strip().splitlines() or ["no output"])[-1]
            report.add(run.status not in (0, None) and expected in run.output, f"fault '{argument}' ends the run", last, "SRS_TGT_009")


def vectors_of(image):
    """Objects that bring vectors and entries of exceptions into an image, from the linker's map."""
    text = image.with_name(image.name + ".map").read_text(encoding="utf-8")
    return set(re.findall(r"^ \.(?:vectors)\s+0x[0-9a-f]+\s+0x[0-9a-f]+ (\S+)$", text, re.MULTILINE))


def check_vectors(report):
    """What runs on the emulator starts, and takes exceptions, by the object that is in the images for silicon."""
    silicon = vectors_of(IMAGES / "firmware/own_device_be32.elf")
    others = [name for name in IMAGES_RUN if vectors_of(IMAGES / f"{name}.elf") != silicon]
    report.add(len(silicon) == 1 and not others, "vectors, start-up and entries of exceptions of every image", ", ".join(others) or
               f"{pathlib.Path(next(iter(silicon), 'none')).name} in {len(IMAGES_RUN) + 1} images", "SRS_TGT_009", "SRS_FW_005")


def in_no_image(build, maps):
    """Objects of core and channels that stand in none of the linker's maps."""
    return [f"{room}/{name}" for room, archive in objects.archives(build) for name, _ in objects.members(archive)
            if not any(f"{archive.relative_to(build)}({name})" in text for text in maps)]


def check_linked(report, count):
    """The objects of the digest are those that the linker took for the images that run."""
    maps = [(IMAGES / f"{name}.elf.map").read_text(encoding="utf-8") for name in IMAGES_RUN]
    missing = in_no_image(TARGET, maps)
    lost = [name for name in missing if not name.startswith(IN_NO_IMAGE)]
    report.add(not lost, "objects of core and channels in the images that run", ", ".join(lost) or f"{count - len(missing)} of {count}; {len(missing)} in none: "
               f"cross link and {len([name for name in missing if not name.startswith(IN_NO_IMAGE[0])])} of the kernel", "SRS_TGT_005")
    others = [text.replace("channel_b/libchannel_b.a", "elsewhere/libchannel_b.a") for text in maps]
    told = [name for name in in_no_image(TARGET, others) if name.startswith("channel_b/")]
    report.add(len(told) == len([name for room, archive in objects.archives(TARGET) if room == "channel_b" for name in objects.members(archive)]),
               "an image with other objects of a channel is told", f"{len(told)} objects", "SRS_TGT_005")


def is_same(ours, theirs):
    """Whether one run gave the same on target and host, with cases and without a failure."""
    return ours is not None and ours == theirs and " failures=0 " in ours and not ours.startswith("cases=0 ")


def check_same_outcomes(report):
    """Lines that begin with run= must be equal on host and target, and no case may fail."""
    host = subprocess.run([PRODUCT / "verification/target/conformance/conformance_host"], capture_output=True, text=True,
                          timeout=600, check=False)
    target = emulator.run_image(IMAGES / "conformance/conformance.bin", count_instructions=False)
    ours, theirs = dict(RUN_LINE.findall(target.output)), dict(RUN_LINE.findall(host.stdout))
    for line in [line for line in target.output.splitlines() if line.startswith(("failed:", "FAILURE"))][:10]:
        print(f"      target {line}")
    for line in [line for line in host.stdout.splitlines() if line.startswith("failed:")][:10]:
        print(f"      host   {line}")
    expected = ("conformance_a", "conformance_b", "differential")
    for run in expected:
        report.add(is_same(ours.get(run), theirs.get(run)), f"{run} big-endian on the target", ours.get(run, "did not end"),
                   "SRS_TGT_001", "SRS_TGT_003")
        report.add(run in theirs, f"{run} on the host", theirs.get(run, "did not end"), "SRS_TGT_003")
    report.add(target.status == 0 and host.returncode == 0, "both programs ended without a failure",
               f"target {target.status}, host {host.returncode}", "SRS_TGT_003")
    line = "cases=9 failures=0 hash=00c0ffee"
    wrong = ["cases=9 failures=0 hash=00c0ffef", "cases=8 failures=0 hash=00c0ffee", "cases=9 failures=1 hash=00c0ffee", None]
    found = sum(not is_same(other, line) for other in wrong) + (not is_same("cases=0 failures=0 hash=0", "cases=0 failures=0 hash=0"))
    report.add(is_same(line, line) and found == 5, "another hash, count, failure or no run is refused", f"{found} of 5", "SRS_TGT_003")
    return ours


def compilers_of(archive, name):
    """What wrote the objects, by their .comment sections or debug information."""
    text = subprocess.run(["arm-none-eabi-readelf", "--string-dump=.comment", str(archive)], capture_output=True, text=True,
                          check=True).stdout
    members = text.count("File: ")
    found = len(re.findall(rf"\]\s+.*{name}", text))
    return found, members


def check_objects(report):
    digest, count = objects.digest(TARGET)
    report.add(count > 0, "objects of core and channels on the target", f"{count} objects, SHA-256 {digest}", "SRS_TGT_005")
    for room, archive in objects.archives(TARGET):
        name = "clang version 19" if room == "channel_b" else "GCC:"
        found, members = compilers_of(archive, name)
        report.add(members > 0 and found == members, f"compiler of {room}", f"{name.strip(':')} in {found} of {members} objects",
                   "SRS_TGT_002")
    foreign = objects.foreign_symbols(TARGET, "arm-none-eabi-")
    report.add(not foreign, "symbols that come from elsewhere", ", ".join(f"{name} ({rooms[0]})" for name, rooms in
                                                                        foreign.items()) or "none", "SRS_TGT_004")
    everything = objects.CERTIFIED + objects.SERVICES
    foreign = objects.foreign_symbols(TARGET, "arm-none-eabi-", everything)
    report.add(not foreign, "symbols that the services of CiA 301, 302, 305 want from elsewhere", ", ".join(
        f"{name} ({rooms[0]})" for name, rooms in foreign.items()) or f"none in {len(objects.SERVICES)} rooms", "SRS_TGT_011")
    only_services = objects.foreign_symbols(TARGET, "arm-none-eabi-", objects.SERVICES)
    report.add(bool(only_services), "a room that is left out is missed", f"{len(only_services)} symbols", "SRS_TGT_011")
    for order, flags in ELF_FLAGS.items():
        image = IMAGES / f"conformance/conformance{'_be32' if order == 'be32' else ''}.elf"
        header = subprocess.run(["arm-none-eabi-readelf", "-h", image], capture_output=True, text=True, check=True).stdout
        found = re.search(r"Flags:\s+0x([0-9a-f]+)", header)
        big = "big endian" in header
        report.add(big and found and int(found.group(1), 16) == flags, f"image in {order} order",
                   f"{image.stat().st_size} bytes, flags 0x{found.group(1) if found else '?'}", "SRS_TGT_008")
    return digest, count


def check_images(report):
    """Every image for silicon against what the controller needs; the emulator's image must be refused there."""
    folder = IMAGES / "firmware"
    for device in firmware_run.DEVICES:
        rows = image_check.check(folder / f"{device}_be32.elf", folder / f"{device}.elf")
        wrong = [f"{text}: {found}" for holds, text, found in rows if not holds]
        report.add(len(rows) >= 25 and not wrong, f"image of {device} for silicon", "; ".join(wrong) or f"{len(rows)} of {len(rows)} checks hold",
                   "SRS_FW_001", "SRS_FW_002", "SRS_FW_003", "SRS_FW_004", "SRS_FW_016", "SRS_FW_019", "SRS_FW_021")
    rows = image_check.check(folder / "actuator.elf")
    refused = [text for holds, text, _ in rows if not holds]
    report.add(all(any(word in text for text in refused) for word in ("ELF flags", "eight vectors", "flash or RAM")),
               "the emulator's image is refused as one for silicon", f"{len(refused)} checks", "SRS_FW_016")
    count, missed = image_fixtures.check(folder / "own_device_be32.elf")
    report.add(count > 100 and not missed, "an image with one thing wrong is refused by the check that looks for it",
               f"not refused: {'; '.join(missed[:3])}" if missed else f"{count} of {count}", "SRS_FW_016")
    application_sources.check(report, TARGET, PRODUCT, folder)
    driver_sources.check(report, TARGET, PRODUCT, [folder / f"{device}_be32.elf" for device in firmware_run.DEVICES])
    different = image_check.variant_differences(ROOT)
    report.add(not different, "memory of the variants as in hal/tms570/chip/variant.hpp", ", ".join(different) or "4 variants", "SRS_FW_017")
    for variant in image_check.VARIANTS:
        rows = image_check.check(folder / f"own_device_{variant}_be32.elf")
        wrong = [f"{text}: {found}" for holds, text, found in rows if not holds]
        report.add(len(rows) >= 20 and not wrong, f"image of own_device for {variant}", "; ".join(wrong) or f"{len(rows)} of {len(rows)} checks hold", "SRS_FW_017")


def check_stack(report):
    """Depth of every entry of the kernel, and that the computation refuses recursion."""
    rows, problems = stack.compute(IMAGES / "bench/bench.elf", TARGET, HERE / "virtual_calls.txt", STACK_ENTRIES)
    for problem in problems:
        print(f"      {problem}")
    report.add(not problems, "greatest stack of the kernel with both channels", f"{rows[0][1]} bytes in {rows[0][0]}", "SRS_TGT_007")
    _, refused = stack.compute(IMAGES / "selftest/selftest.elf", TARGET, HERE / "selftest/virtual_calls.txt", ["TargetMain"])
    recursion = [problem for problem in refused if problem.startswith("recursion: ")]
    report.add(len(recursion) == 1, "recursion in the fixture is refused", recursion[0] if recursion else "it was not", "SRS_TGT_007")
    return rows


def count_instructions(report):
    """Executed instructions a repetition of the benchmark's items."""
    run = emulator.run_image(IMAGES / "bench/bench.bin")
    items = {f"{item} {srdos}": int(total) / int(repetitions)
             for item, srdos, repetitions, total in CYCLE_LINE.findall(run.output)}
    idle = items.get("idle 64", 0.0)
    report.add(run.status == 0 and idle > 0, "instructions of the benchmark on the target (64 SRDOs)",
               f"idle cycle {idle:.0f}, pair with its cycle {items.get('pair 64', 0.0):.0f}, two cycles with a sent pair "
               f"{items.get('send 64', 0.0):.0f}, check {items.get('check 64', 0.0):.0f}", "SRS_TGT_006")
    return items


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--no-build", action="store_true")
    parser.add_argument("--tests", action="store_true")
    arguments = parser.parse_args()
    covered = [coverage_run.SUITE] + ([coverage_run.TESTS, *coverage_run.BY_LAYOUT] if arguments.tests else [])
    if not arguments.no_build:
        print("Building build/target (big-endian, two compilers) and the same programs in build/product ...", flush=True)
        target_build.build_preset("tms570", ["selftest", "bench", "conformance", "conformance_be32", *firmware_run.DEVICES, "trap",
                                               "manager", "manager_be32", *target_build.SERVICE_TARGETS,
                                               *(f"{device}_be32" for device in firmware_run.DEVICES),
                                               *(f"own_device_{variant}_be32" for variant in image_check.VARIANTS),
                                               *target_build.CERTIFIED_TARGETS], TARGET)
        target_build.build_preset("product", ["conformance_host", "third_voice_host", "manager_host", *(f"firmware_{device}_host" for device in firmware_run.DEVICES)])
        cortex_m_run.build()
        zynqmp_run.build()
        zynqmp_hal_run.build()
        coverage_run.build(covered)
    report = Report()
    check_selftest(report)
    check_vectors(report)
    digest, count = check_objects(report)
    check_linked(report, count)
    outcomes = check_same_outcomes(report)
    manager_run.check(report, IMAGES / "manager", PRODUCT / "verification/target/manager")
    costs = firmware_run.check(report, IMAGES / "firmware", PRODUCT / "verification/target/firmware")
    check_images(report)
    byte_order.check(report, TARGET, PRODUCT)
    cortex_m_run.check(report, PRODUCT / "verification/target/conformance/conformance_host")
    zynqmp_hal_run.check(report)
    zynqmp_run.check(report, PRODUCT / "verification/target",
                     IMAGES / "conformance/conformance.bin", compilers_of)
    coverage = coverage_run.check(report, covered)
    rows = check_stack(report)
    items = count_instructions(report)
    result = {"digest": digest, "objects": count, "outcomes": outcomes, "instructions": items, "firmware_cycles": costs, "coverage": coverage,
              "stack": [{"entry": name, "bytes": size, "path": path} for name, size, path in rows],
              "checks": report.rows, "requirements": report.requirements(), "passed": report.passed()}
    (TARGET / "target.json").write_text(json.dumps(result, indent=2) + "\n", encoding="utf-8")
    good = sum(row["holds"] for row in report.rows)
    print(f"target: {good} of {len(report.rows)} checks hold")
    return 0 if report.passed() else 1


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (image_check.BadInput, objects.BadInput, stack.BadInput, target_build.BadInput, zynqmp_machine.BadRun, OSError, subprocess.SubprocessError) as problem:
        print(f"run_target.py: {problem}", file=sys.stderr)
        sys.exit(2)
