"""The firmware examples on the emulator: scenarios as on the host, and misdeeds that must end in an exception."""
import json
import pathlib
import re
import subprocess
import tempfile

import emulator

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
SCENARIOS = HERE / "firmware/scenarios"
DEVICES = ("sensor", "actuator", "own_device")
COST_LINE = re.compile(r"^cost greatest=(\d+) cycles=(\d+) stack=(\d+)\n", re.MULTILINE)
RECORD = re.compile(r"exception cause=(\d+) accessed=([0-9a-f]{8}) place=([0-9a-f]{8}) count=1 outputs=closed")
# Who does it to whom, by the numbers of trap/device.cpp, and in whose code it then is: a channel by its own commit.
VICTIMS = ["region_channel_a", "region_channel_b", "region_core", "region_non_safety", "stack_main_bottom", "flash_core_start", None,
           "_ZN12counterpoint8firmware12_GLOBAL__N_14pinsE"]  # The last one is of the safe rest.
DATA_ACCESS, INSTRUCTION, PROGRAM = 1, 3, 5
MISDEEDS = [("channel A", 1, "flash_channel_a", (1, 2, 5)), ("channel B", 2, "flash_channel_b", (0, 2, 5)), ("the core", 3, None, (0, 1, 5)),
            ("non-safety code", 4, None, (0, 1, 2, 4, 5, 6, 7))]
WRONG_STEPS = [("an undefined instruction", 5, INSTRUCTION), ("a foreign supervisor call", 6, PROGRAM), ("a jump into data", 7, DATA_ACCESS)]
# A pair and an acknowledge release the drive; then the misdeed, then a pair with another value for the channels to write.
TRAP_SCENARIO = """5000 nmt operational
30000 frame 103 1 1
30300 frame 104 fe fe
32500 input 1
34500 expect outputs 1
35500 input {pins:x}
50000 frame 103 0 0
50300 frame 104 ff ff
55000 end
"""


def device_of(scenario):
    return next(device for device in DEVICES if scenario.stem.startswith(device))


def run_scenario(image, path):
    """The run, without the line of costs, and the costs."""
    run = emulator.run_image(image, str(path.relative_to(ROOT)), folder=ROOT)
    cost = COST_LINE.search(run.output)
    return run.status, COST_LINE.sub("", run.output), tuple(map(int, cost.groups())) if cost else None


def check_scenarios(report, images, hosts):
    """Every scenario holds on both and prints the same."""
    costs = {}
    paths = sorted(SCENARIOS.glob("*.txt"))
    for path in paths:
        device = device_of(path)
        status, output, cost = run_scenario(images / f"{device}.bin", path)
        host = subprocess.run([hosts / f"firmware_{device}_host", path], capture_output=True, text=True, timeout=1800, check=False)
        failures = [line for line in (output + host.stdout).splitlines() if "FAILURE" in line or line.startswith("exception")]
        for line in failures[:5]:
            print(f"      {path.stem}: {line}")
        holds = status == 0 and host.returncode == 0 and output == host.stdout and output.count("\n") > 1 and cost is not None
        report.add(holds, f"scenario {path.stem} on the target and on the host",
                   f"{output.count(chr(10))} lines, {'equal' if output == host.stdout else 'DIFFERENT'}", "SRS_FW_008", "SRS_FW_009", *(["SRS_FW_018"] if device == "own_device" else []),
                   *(["SRS_FW_022"] if path.stem.endswith("reset") else []))
        costs[path.stem] = cost
    report.add(len(paths) >= 9, "scenarios of the firmware examples", f"{len(paths)}", "SRS_FW_009")
    return costs


def check_refused_scenario(report, images):
    """An expectation that does not hold and a line that cannot be read fail a run."""
    for text, expected in (("5000 expect outputs 1\n6000 end\n", "expected outputs"), ("5000 expct outputs 1\n", "expected '<us> <event>'")):
        with tempfile.NamedTemporaryFile("w", suffix=".txt", dir=ROOT / "build") as wrong:
            wrong.write(text)
            wrong.flush()
            status, output, _ = run_scenario(images / "actuator.bin", pathlib.Path(wrong.name))
        report.add(status not in (0, None) and expected in output, f"a scenario with '{text.split(chr(10))[0]}' fails",
                   (output.strip().splitlines() or ["no output"])[-1], "SRS_FW_009")


def symbols_of(elf):
    text = subprocess.run(["arm-none-eabi-nm", str(elf)], check=True, capture_output=True, text=True).stdout
    return {fields[2]: int(fields[0], 16) for fields in map(str.split, text.splitlines()) if len(fields) == 3}


def trap(images, pins):
    """Cause, address and place of the exception that a misdeed ends in, or what it printed instead."""
    with tempfile.NamedTemporaryFile("w", suffix=".txt", dir=ROOT / "build") as scenario:
        scenario.write(TRAP_SCENARIO.format(pins=2 * pins))
        scenario.flush()
        status, output, _ = run_scenario(images / "trap/trap.bin", pathlib.Path(scenario.name))
    record = RECORD.search(output)
    if status in (0, None) or record is None or "FAILURE" in output:
        return None, (output.strip().splitlines() or ["no output"])[-1]
    return tuple(int(field, base) for field, base in zip(record.groups(), (10, 16, 16))), record.group(0)


def check_traps(report, images):
    symbols = symbols_of(images / "trap/trap.elf")
    for name, who, code, victims in MISDEEDS:
        for what in victims:
            victim = VICTIMS[what]
            address = symbols[victim] if victim else 0xFFFFFF5C
            found, text = trap(images, who + 16 * what)
            inside = found and (code is None or symbols[f"{code}_start"] <= found[2] < symbols[f"{code}_end"])
            requirement = "SRS_FW_007" if who == 4 else "SRS_FW_006"
            report.add(found and found[:2] == (DATA_ACCESS, address) and inside, f"a write of {name} to {victim or 'a register'}", text,
                       requirement, "SRS_FW_005", "SRS_FW_002")
    for name, who, cause in WRONG_STEPS:
        found, text = trap(images, who)
        report.add(found and found[0] == cause, f"{name} in non-safety code", text, "SRS_FW_005")
    found, text = trap(images, 0)
    report.add(found is None and "exception" not in text, "the same device without a misdeed runs on", text, "SRS_FW_006", "SRS_FW_007")


def most_instructions():
    """The limit of the dearest cycle; where it is a known gap, what it may not exceed until it is met."""
    rows = json.loads((ROOT / "verification/bench/limits.json").read_text(encoding="utf-8"))["items"]
    gaps = json.loads((ROOT / "docs/known_gaps.json").read_text(encoding="utf-8"))["gaps"]
    limit = next(row["must"] for row in rows if row["id"] == "fw_cycle")
    return max([limit] + [gap["no_worse_than"]["fw_cycle"] for gap in gaps if "fw_cycle" in gap.get("no_worse_than", {})])


def check(report, images, hosts):
    costs = check_scenarios(report, images, hosts)
    worst = (costs.get("own_device_worst") or (0,))[0]
    most = most_instructions()
    report.add(0 < worst <= most, "dearest cycle of a device with 4 SRDOs, protection included", f"{worst} instructions, at most {most}", "SRS_FW_013")
    check_refused_scenario(report, images)
    check_traps(report, images)
    return costs
