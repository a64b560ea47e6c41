"""Cost of the services around the kernel on the target: bytes by service, and the load of a whole device.

[SRS_BEN_012, SRS_BEN_013]"""
import json
import re
import subprocess

import emulator

# Which source files are which service; every object of the rooms is in exactly one row.
SERVICES = {
    "dictionary": ["dictionary", "entry_value", "foreign_objects", "number_hook", "cob_id"],
    "sdo_server": ["sdo_server", "sdo_server_block", "sdo_server_segment", "sdo_server_port", "sdo_parameters", "crc16"],
    "sdo_client": ["sdo_client", "sdo_client_block", "sdo_client_dispatch", "sdo_client_segment", "sdo_client_port"],
    "nmt": ["nmt_slave"],
    "heartbeat": ["heartbeat_producer", "heartbeat_consumer"],
    "guarding": ["node_guarding"],
    "emergency": ["emergency_producer", "emergency_consumer", "communication_errors", "service_objects"],
    "sync": ["sync"],
    "time": ["time_stamp"],
    "pdo": ["tpdo", "tpdo_settings", "rpdo", "rpdo_settings", "pdo_mapping", "pdo_objects", "pdo_settings"],
    "store": ["parameter_store", "stored_image", "stored_parts"],
    "lss": ["lss_slave", "lss_configuration", "stored_lss"],
    "device": ["device", "device_services", "frame_ring", "kernel_watch", "outbox", "safety_objects", "safety_queue", "services"],
    "generated": ["configuration", "constant_objects", "numbers", "stored_objects"],
}
ROOMS = ["canopen/cia301/libcanopen_cia301.a", "canopen/cia305/libcanopen_cia305.a", "canopen/device/libcanopen_device.a",
         "canopen/generated/libcanopen_generated.a"]
TARGETS = ["canopen_cia301", "canopen_cia305", "canopen_device", "canopen_generated"]
RAM_LINE = re.compile(r"service_ram=(\w+) bytes=(\d+)")
LOAD_LINE = re.compile(r"item=(\w+) srdos=\d+ repetitions=(\d+) instructions=(\d+)")
MEMBER = re.compile(r"^(\S+)\.cpp\.obj?\s+\(ex ")
SECTION = re.compile(r"^\.(text|rodata|data)(?:\.\S*)?\s+(\d+)\s")
MIX_ADDRESS = 0x00600000
BUS_BITS = 1000000
WANTED_LOAD = 0.9


class BadInput(Exception):
    """What was built or measured cannot be used; the text says why."""


def code_by_service(folder, services=None):
    """Bytes of code, constants and initialised data by service."""
    services = services or SERVICES
    service_of = {source: service for service, sources in services.items() for source in sources}
    sizes = dict.fromkeys(services, 0)
    seen = set()
    for room in ROOMS:
        text = subprocess.run(["arm-none-eabi-size", "-A", str(folder / room)], check=True, capture_output=True, text=True).stdout
        service = None
        for line in text.splitlines():
            member, section = MEMBER.match(line), SECTION.match(line)
            if member:
                source = member.group(1)
                if source not in service_of:
                    raise BadInput(f"{room}: {source}.cpp belongs to no service, expected it in services.py")
                service = service_of[source]
                seen.add(source)
            elif section and service:
                sizes[service] += int(section.group(2))
    missing = sorted(set(service_of) - seen)
    if missing:
        raise BadInput(f"{', '.join(missing)}: a service without its object, expected {missing[0]}.cpp in {folder}")
    return sizes


def bites(folder):
    """Whether a source file that no service has is found, and a service without its object."""
    for wrong in ({**SERVICES, "sync": []}, {**SERVICES, "sync": ["sync", "no_such_source"]}):
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
    run = emulator.run_image(image, seconds=120, files={mix_path: MIX_ADDRESS})
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
