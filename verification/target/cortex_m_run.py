"""Core, channels and services for Cortex-M: what they want from elsewhere, and the suite on the emulator's boards."""
import re
import subprocess

import emulator
import objects
import target_build

# Processor -> board of QEMU, first addresses of its code and of its RAM, differential sequences.
BOARDS = {"cortex-m3": ("mps2-an385", 0x00000000, 0x20000000), "cortex-m4": ("mps2-an386", 0x00000000, 0x20000000),
          "cortex-m7": ("mps2-an500", 0x00000000, 0x20000000), "cortex-m33": ("mps2-an505", 0x10000000, 0x38000000)}
RUNS = ("conformance_a", "conformance_b", "differential")
# What a port starts from, with the library that it stands on, and how many sources it has.
SKELETON = [("examples/port_skeleton", "examples/port_skeleton/libport_skeleton.a"), ("hal/api", "hal/api/libhal_api.a")]
SKELETON_SOURCES = 11
# So many sequences on each processor; the Cortex-R5F runs a hundred times as many.
ARGUMENT = "short"


def folder(processor):
    return target_build.ROOT / "build" / processor


def build():
    for processor, (_, code, ram) in BOARDS.items():
        target_build.run("cmake", "-G", "Ninja", "-S", target_build.ROOT, "-B", folder(processor), "--toolchain",
                         target_build.ROOT / "cmake/toolchain-cortex-m.cmake", "-DCOUNTERPOINT_HOST=OFF",
                         "-DCOUNTERPOINT_CHANNEL_B_COMPILER=clang++-19", f"-DCOUNTERPOINT_CORTEX_M={processor}",
                         f"-DCOUNTERPOINT_CORTEX_M_ROM={code:#x}", f"-DCOUNTERPOINT_CORTEX_M_RAM={ram:#x}")
        target_build.run("cmake", "--build", folder(processor), "--parallel", target_build.JOBS, "--target", "conformance",
                         "port_skeleton", *target_build.CERTIFIED_TARGETS, *target_build.SERVICE_TARGETS)


def outcomes(text):
    return dict(re.findall(r"^run=(\S+) (.*)$", text, re.MULTILINE))


def same(ours, theirs):
    """Whether all runs ended, with cases, without a failure, and alike."""
    return all(ours.get(run) == theirs.get(run) and " failures=0 " in ours.get(run, "") and not ours[run].startswith("cases=0 ")
               for run in RUNS)


def check(report, host_program):
    host = subprocess.run([host_program, ARGUMENT], capture_output=True, text=True, timeout=600, check=False)
    expected = outcomes(host.stdout)
    for processor, (board, _, _) in BOARDS.items():
        image = folder(processor) / "verification/target/conformance/conformance.elf"
        run = emulator.run_board(board, image, ARGUMENT)
        found = outcomes(run.output)
        told = "; ".join(f"{name} {found.get(name, 'did not end')}" for name in RUNS)
        report.add(run.status == 0 and same(found, expected), f"all cases and sequences little-endian on {processor}", told, "SRS_TGT_012")
        foreign = objects.foreign_symbols(folder(processor), "arm-none-eabi-", objects.CERTIFIED + objects.SERVICES)
        report.add(not foreign, f"symbols from elsewhere for {processor}", ", ".join(foreign) or "none", "SRS_TGT_012")
        foreign = objects.foreign_symbols(folder(processor), "arm-none-eabi-", SKELETON)
        count = len(objects.members(folder(processor) / SKELETON[0][1]))
        report.add(not foreign and count == SKELETON_SOURCES, f"skeleton of a port for {processor}",
                   ", ".join(foreign) or f"{count} of {SKELETON_SOURCES} objects, none", "SRS_HAL_560")
    wrong = [{**expected, "conformance_b": expected.get("conformance_b", "") + "0"}, {**expected, "differential": None},
             {name: text for name, text in expected.items() if name != "conformance_a"}, {}]
    refused = sum(not same({name: text for name, text in other.items() if text is not None}, expected) for other in wrong)
    report.add(refused == len(wrong) and same(expected, expected), "another hash or a run that did not end is refused",
               f"{refused} of {len(wrong)}", "SRS_TGT_012")
