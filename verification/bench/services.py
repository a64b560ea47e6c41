"""Cost of the services around the kernel on the target: bytes by service, and the load of a whole device.

[SRS_BEN_012, SRS_BEN_013]"""
import json
import re
import subprocess

import emulator

# Which sources are which service: beginnings of their paths below canopen, the longest one counts. Every object of the rooms has one row.
SERVICES = {
    "dictionary": ["cia301/base/", "cia301/dictionary/"],
    "sdo_server": ["cia301/sdo/server", "cia301/sdo/block_rest", "cia301/sdo/parameters", "cia301/store/crc16"],
    "sdo_client": ["cia301/sdo/client"],
    "nmt": ["cia301/nmt/slave"],
    "heartbeat": ["cia301/nmt/heartbeat"],
    "guarding": ["cia301/nmt/node_guarding"],
    "emergency": ["cia301/emergency/", "cia301/objects/"],
    "sync": ["cia301/time/sync"],
    "time": ["cia301/time/time_stamp"],
    "pdo": ["cia301/pdo/"],
    "store": ["cia301/store/"],
    "lss": ["cia305/"],
    "device": ["device/"],
    "generated": ["generated/"],
}
ROOMS = {"cia301": "canopen_cia301", "cia305": "canopen_cia305", "device": "canopen_device", "generated": "canopen_generated"}
TARGETS = list(ROOMS.values())
RAM_LINE = re.compile(r"service_ram=(\w+) bytes=(\d+)")
LOAD_LINE = re.compile(r"item=(\w+) srdos=\d+ repetitions=(\d+) instructions=(\d+)")
SECTION = re.compile(r"^\.(text|rodata|data)(?:\.\S*)?\s+(\d+)\s")
MIX_ADDRESS = 0x00600000
BUS_BITS = 1000000
WANTED_LOAD = 0.9


class BadInput(Exception):
    """What was built or measured cannot be used; the text says why."""


def objects(folder):
    """Path of a source below canopen, without its ending, and its object: those of the archives as they are linked now."""
    for room, target in ROOMS.items():
        place = f"canopen/{room}/CMakeFiles/{target}.dir/"
        listed = subprocess.run(["ninja", "-C", str(folder), "-t", "query", f"canopen/{room}/lib{target}.a"], check=True, capture_output=True, text=True).stdout
        for name in sorted({word for word in listed.split() if word.startswith(place) and word.endswith(".cpp.obj")}):
            yield f"{room}/{name.removeprefix(place).removesuffix('.cpp.obj')}", folder / name


def code_by_service(folder, services=None):
    """Bytes of code, constants and initialised data by service."""
    beginnings = {beginning: service for service, all_of in (services or SERVICES).items() for beginning in all_of}
    sizes = dict.fromkeys(services or SERVICES, 0)
    unseen = set(beginnings)
    for source, path in objects(folder):
        fitting = [beginning for beginning in beginnings if source.startswith(beginning)]
        if not fitting:
            raise BadInput(f"canopen/{source}.cpp belongs to no service, expected it in services.py")
        mine = max(fitting, key=len)
        unseen.discard(mine)
        text = subprocess.run(["arm-none-eabi-size", "-A", str(path)], check=True, capture_output=True, text=True).stdout
        sizes[beginnings[mine]] += sum(int(found.group(2)) for found in map(SECTION.match, text.splitlines()) if found)
    if unseen:
        raise BadInput(f"{', '.join(sorted(unseen))}: a service without its object, expected one in {folder}")
    return sizes


def bites(folder):
    """Whether a source file that no service has is found, and a service without its object."""
    for wrong in ({**SERVICES, "sync": []}, {**SERVICES, "sync": ["cia301/time/sync", "no_such_source"]}):
        try:
            code_by_service(folder, wrong)
        except BadInput:
            continue
        return False
    return True


def make_mix(program, path):
    """Runs the device on the simulated bus; what was on it in the measured second."""
    done = subprocess.run([str(program), str(path)], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise BadInput(f"{program}: exit status {done.returncode}, the device was not well: {done.stdout}{done.stderr}")
    mix = json.loads(done.stdout)
    mix["load"] = mix["bits"] / BUS_BITS
    if mix["load"] < WANTED_LOAD:
        raise BadInput(f"the bus was used {mix['load']:.1%} of the time, expected at least {WANTED_LOAD:.0%}")
    return mix


def load_on_target(image, mix_path):
    """Instructions of one second, without those of the meter; RAM of each service."""
    run = emulator.run_image(image, seconds=1800, files={mix_path: MIX_ADDRESS})
    if run.status != 0:
        raise BadInput(f"{image}: exit status {run.status} on the emulator\n{run.output}")
    sums = {item: (int(count), int(total)) for item, count, total in LOAD_LINE.findall(run.output)}
    count, total = sums["service_load"]
    brackets, bracket_total = sums["nothing"]
    ram = {service: int(size) for service, size in RAM_LINE.findall(run.output)}
    unknown = sorted({service.removesuffix("_each").split("_field")[0].split("_frame")[0] for service in ram} - set(SERVICES))
    if unknown:
        raise BadInput(f"{image}: RAM of {unknown[0]}, which is no service of services.py")
    return total - count * bracket_total / brackets, ram


def measure(product, target, small, results):
    """Everything about services, as it goes into bench.json."""
    mix = make_mix(product / "verification/bench/bench_mix", results / "mix.bin")
    load, ram = load_on_target(target / "verification/target/bench/bench_whole.bin", results / "mix.bin")
    return {"mix": mix, "load": load, "ram": ram, "code": code_by_service(small), "bites": bites(small)}


def print_costs(services):
    """The table of services, and what was on the bus."""
    print(f"{'service':12} {'code -Os [B]':>12} {'RAM [B]':>8}  and for each")
    for service, code in services["code"].items():
        each = [f"{name.removeprefix(service + '_').removesuffix('_each').removesuffix('each') or 'one'} {size} B"
                for name, size in services["ram"].items() if name.startswith(service + "_") and name.endswith("each")]
        print(f"{service:12} {code:12} {services['ram'].get(service, 0):8}  {', '.join(each)}")
    mix = services["mix"]
    print(f"frames of the whole device's second, {mix['load']:.1%} of 1 Mbit/s: " + ", ".join(
        f"{share['count']} {name} {share['bits'] / BUS_BITS:.1%}" for name, share in mix["frames"].items() if share["count"]) +
        f"; {mix['sdo_bytes']} B by SDO")
