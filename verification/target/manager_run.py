"""The network manager on the emulated processor and on the host: what it tells, and each frame, as recorded."""
import pathlib
import subprocess

import emulator

HERE = pathlib.Path(__file__).resolve().parent
RECORDED = HERE / "manager/expected.txt"
SCENES = 5
ROOM = "room of a manager: "


def lines_of(output):
    """What must be the same everywhere; the room depends on the size of a pointer."""
    return [line for line in output.splitlines() if not line.startswith(ROOM)]


def difference(recorded, found):
    """The first line that differs, or an empty text."""
    for number, (expected, line) in enumerate(zip(recorded, found), start=1):
        if line != expected:
            return f"line {number}: '{line}', expected '{expected}'"
    if len(recorded) != len(found):
        return f"{len(found)} lines, expected {len(recorded)}"
    return ""


def passes(recorded, found):
    """Whether every scene was played, none failed, and all is as recorded."""
    played = [line for line in found if line.startswith("run=") and line.endswith(" failures=0 passed")]
    return len(played) == SCENES and not difference(recorded, found)


def check(report, images, programs):
    recorded = RECORDED.read_text(encoding="utf-8").splitlines()
    target = emulator.run_image(images / "manager.bin", count_instructions=False)
    host = subprocess.run([programs / "manager_host"], capture_output=True, text=True, timeout=1800, check=False)
    runs = (("big-endian on the target", target.status, target.output), ("on the host", host.returncode, host.stdout))
    for where, status, output in runs:
        found = lines_of(output)
        holds = status == 0 and passes(recorded, found)
        report.add(holds, f"network manager with a safety device {where}",
                   f"{SCENES} scenes, {len(found)} lines as recorded" if holds else difference(recorded, found) or f"exit status {status}",
                   "SRS_TGT_010")
    room = [line.removeprefix(ROOM) for line in target.output.splitlines() if line.startswith(ROOM)]
    report.add(len(room) == 1, "room of a manager on the target", room[0] if room else "not told", "SRS_TGT_010")
    swapped = [line.replace("00000032 read 0000003c", "32000000 read 3c000000") for line in recorded]
    wrong = [recorded[:-1], recorded + ["1 manager 1: node 33 NMT start"], swapped, [line.replace("hash=", "hash=0") for line in recorded], []]
    refused = sum(not passes(recorded, other) for other in wrong)
    report.add(refused == len(wrong) and passes(recorded, recorded), "other bytes, an event more or less, no run are refused",
               f"{refused} of {len(wrong)}", "SRS_TGT_010")
