#!/usr/bin/env python3
"""A CANopen client of other origin (canopen, python-can) reads the dictionaries of generated code over SDO.

    generated_client.py --program GENERATED_NODE --can ADDRESS [--root DIR] [--patience N] [CASE ...]

GENERATED_NODE is the program of tests/canopen/generate that is built from the generated code of many device files. For each
CASE (default: all) it is started on the bus, and every data element that the client's own reader of EDS and DCF finds in the
device file is read and compared with the value that this reader has for it. One line a case; exit status 0 only when all hold.
"""
import argparse
import configparser
import io
import logging
import pathlib
import re
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(ROOT / "tests/runtime/clients")]
import canopen  # noqa: E402
from canopen.objectdictionary import datatypes  # noqa: E402
from canopen.sdo import SdoAbortedError, SdoClient  # noqa: E402
from node_bus import open_bus  # noqa: E402

WRITE_ONLY = 0x06010001
NOT_THERE = {0x06020000, 0x06090011, 0x08000022}  # The last one: of a kernel without SRDOs, which was not started.
NO_VALUE = {0x08000000, WRITE_ONLY} | NOT_THERE  # The client takes types that it does not know for DOMAIN.
CONSUMER = 2
DOMAIN_OBJECT = 2
TYPE_OBJECT = 5
SHORT_TYPES = range(0x30, 0x38)
TIMES = (datatypes.TIME_OF_DAY, datatypes.TIME_DIFFERENCE)  # The client does not encode them: six bytes.
TEXT = (datatypes.VISIBLE_STRING, datatypes.OCTET_STRING, datatypes.UNICODE_STRING)


def keys_of(body):
    return dict(re.findall(r"^(\w+)[ \t]*=[ \t]*(-?\w+)", body, flags=re.MULTILINE))


def type_of(sections, index, sub, keys):
    """Of what has no type of its own: a DOMAIN, or a member of a record, whose structure (DEFSTRUCT) knows it."""
    if int(keys.get("ObjectType", "7"), 0) == DOMAIN_OBJECT:
        return hex(datatypes.DOMAIN)
    structure = int(keys_of(sections[index]).get("DataType", "0"), 0)
    return keys_of(sections.get(f"{structure:04X}sub{sub}", "")).get("DefaultValue", "0") if sub else "0"


def is_short(sections, data_type):
    """Less than a byte: BIT1 to BIT8, or a type of the file (DEFTYPE), whose value is its length."""
    own = keys_of(sections.get(f"{data_type:04X}", ""))
    is_own = int(own.get("ObjectType", "0"), 0) == TYPE_OBJECT and int(own.get("DefaultValue", "99"), 0) <= 8
    return data_type in SHORT_TYPES or is_own


class DeviceText(io.StringIO):
    """The objects of a file from 1000h on: about other sections the client's reader is strict, and they are no data elements.
    And what it does not read of them."""

    def __init__(self, path):
        self.name = str(path)
        self.compact = {}  # CompactSubObj: sub-indices by index.
        self.domains = set()  # Objects of the kind DOMAIN, which may have any data type.
        self.values = {}  # Of [1028Value], by index and sub-index.
        self.variables = set()  # SRDOMapping=1: the kernel lets them be read, whatever their access.
        self.bits = set()  # Elements shorter than a byte: types that the client takes for DOMAIN.
        kept = []
        text = path.read_text(encoding="latin-1")  # Bytes stay as they are.
        sections = {head: body for head, _, body in (part.partition("]") for part in re.split(r"^\[", text, flags=re.M)[1:])}
        for head, body in sections.items():
            match = re.fullmatch(r"([1-9A-F][0-9A-F]{3})(?:sub([0-9A-F]+)|(value))?", head, flags=re.IGNORECASE)
            if match is None:
                continue
            index, keys = int(match[1], 16), keys_of(body)
            if match[3]:
                self.values |= {(index, int(sub)): int(value, 0) for sub, value in keys.items() if sub.isdigit()}
                continue
            if not keys.get("DataType"):
                keys["DataType"] = type_of(sections, match[1], match[2], keys)
                body = f"{body.rstrip()}\nDataType={keys['DataType']}\n\n"
            kept.append(f"[{head}]{body}")
            if "CompactSubObj" in keys:
                self.compact[index] = int(keys["CompactSubObj"], 0)
            if int(keys.get("SRDOMapping", "0"), 0) == 1:
                self.variables.add((index, int(match[2], 16)) if match[2] else index)
            if is_short(sections, int(keys["DataType"], 0)):
                self.bits.add((index, int(match[2], 16)) if match[2] else index)
            if int(keys.get("ObjectType", "7"), 0) == DOMAIN_OBJECT:
                self.domains.add((index, int(match[2] or "0", 16)))
        super().__init__("".join(kept))


def variables(dictionary, compact):
    """All data elements from 1000h on; below are data types."""
    for entry in dictionary.values():
        if entry.index < 0x1000:
            continue
        if isinstance(entry, canopen.objectdictionary.ODVariable):
            yield entry
        else:
            is_array = isinstance(entry, canopen.objectdictionary.ODArray)
            subs = set(entry.subindices) | set(range(1, compact.get(entry.index, 0) + 1) if is_array else ())
            yield from (entry[sub] for sub in sorted(subs))


def value_of(variable):
    return variable.value if variable.value is not None else variable.default


def raw_of(variable):
    """The text in the file, where there is one."""
    return getattr(variable, "value_raw", None) or getattr(variable, "default_raw", None) or None


def number_at(dictionary, index, sub, missing=0):
    try:
        entry = dictionary[index]
        variable = entry if isinstance(entry, canopen.objectdictionary.ODVariable) else entry[sub]
        value = value_of(variable)
    except KeyError:
        return missing
    return int.from_bytes(value, "little") if isinstance(value, bytes) else (value or 0)


def safe_values(dictionary):
    """What consumed variables are before the first pair: 5F02h, first mapped bit lowest. By index and sub-index."""
    values = {}
    for number in range(1, 65):
        if number_at(dictionary, 0x1300 + number, 1) != CONSUMER:
            continue
        rest = number_at(dictionary, 0x5F02, number)
        count = number_at(dictionary, 0x1380 + number, 0)
        for place in range(1, count, 2):
            normal, inverse = (number_at(dictionary, 0x1380 + number, sub) for sub in (place, place + 1))
            bits = normal & 0xFF
            mask = (1 << bits) - 1
            size = (bits + 7) // 8
            values[normal >> 16, normal >> 8 & 0xFF] = (rest & mask).to_bytes(size, "little")
            values[inverse >> 16, inverse >> 8 & 0xFF] = (~rest & mask).to_bytes(size, "little")
            rest >>= bits
    return values


def expected_of(variable, safe, device):
    """Bytes, or a set of abort codes of which one is right."""
    place = variable.index, variable.subindex
    if place in safe:
        return safe[place]
    is_short = place in device.bits or variable.index in device.bits
    if place in device.domains or (variable.data_type == datatypes.DOMAIN and not is_short):
        return NO_VALUE
    is_variable = place in device.variables or variable.index in device.variables
    if variable.access_type == "wo" and not is_variable:
        return {WRITE_ONLY}
    raw = raw_of(variable)
    if is_short:
        return bytes([int(raw or "0", 0)])
    if raw is not None and value_of(variable) is None:
        # The bits of a real number, or octets that are no hexadecimal digits: the client has only the text.
        return raw.encode("latin-1") if variable.data_type in TEXT else int(raw, 0).to_bytes(len(variable) // 8, "little")
    value = device.values.get(place, value_of(variable))
    if value is None and variable.subindex == 0:
        value = device.compact.get(variable.index)
    if variable.data_type in TEXT:
        data = b"" if value is None else value if isinstance(value, bytes) else str(value).encode("latin-1")
        return data.decode("utf-8").encode("utf_16_le") if variable.data_type == datatypes.UNICODE_STRING else data
    if value is None:
        # Without a value: 0, or the limit next to it.
        value = max(0, variable.min or 0) if variable.max is None or variable.max >= 0 else variable.max
    if variable.data_type in datatypes.SIGNED_TYPES and value >> (len(variable) - 1) == 1:
        value -= 1 << len(variable)  # Files write the bits of negative numbers, too.
    return value.to_bytes(6, "little") if variable.data_type in TIMES else variable.encode_raw(value)


def answer_of(client, variable):
    try:
        return client.upload(variable.index, variable.subindex)
    except SdoAbortedError as error:
        return error.code


def shown(answer):
    if isinstance(answer, set):
        return " or ".join(shown(code) for code in sorted(answer))
    return f"{answer:08X}h" if isinstance(answer, int) else answer.hex() or "nothing"


def compare(client, device):
    """(data elements, what differs)."""
    dictionary = client.od
    safe = safe_values(dictionary)
    count, problems = 0, []
    for variable in variables(dictionary, device.compact):
        wanted, got = expected_of(variable, safe, device), answer_of(client, variable)
        count += 1
        if not (got in wanted if isinstance(wanted, set) else got == wanted):
            problems.append(f"{variable.index:04X}h:{variable.subindex:02X} {variable.name}: {shown(got)}, expected {shown(wanted)}")
    return count, problems


def dictionary_of(device, node_id):
    """As the client reads it; None where its reader cannot."""
    try:
        return canopen.import_od(device, node_id)
    except (configparser.Error, KeyError, ValueError):
        return None


def serve_and_compare(options, name, client, device):
    process = subprocess.Popen([options.program, name, options.can], stdout=subprocess.PIPE, text=True)
    network = canopen.Network()
    try:
        if not process.stdout.readline():
            return 0, ["the program ended before it served anything"]
        network.bus = open_bus(options.can)
        network.connect()
        client.network = network
        network.subscribe(client.tx_cobid, client.on_response)
        client.RESPONSE_TIMEOUT = 2.0 * options.patience
        return compare(client, device)
    finally:
        network.disconnect()
        process.terminate()
        process.wait(10 * options.patience)


def main():
    logging.getLogger("canopen").setLevel(logging.CRITICAL)  # Refused transfers are what is asked for.
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("case", nargs="*")
    parser.add_argument("--program", required=True)
    parser.add_argument("--can", required=True)
    parser.add_argument("--root", type=pathlib.Path, default=ROOT)
    parser.add_argument("--patience", type=int, default=1)
    options = parser.parse_args()
    listed = subprocess.run([options.program, "--list"], check=True, capture_output=True, text=True).stdout.splitlines()
    cases = {name: (int(node_id), file) for name, node_id, file in (line.split(" ", 2) for line in listed)}
    unknown = [name for name in options.case if name not in cases]
    if unknown:
        parser.error(f"no case '{unknown[0]}', expected one of {', '.join(cases)}")
    failed = 0
    for name in options.case or cases:
        started = time.monotonic()
        node_id, file = cases[name]
        device = DeviceText(options.root / file)
        dictionary = dictionary_of(device, node_id)
        count, problems = 0, ["the client's reader refuses it"]
        if dictionary is not None:
            count, problems = serve_and_compare(options, name, SdoClient(0x600 + node_id, 0x580 + node_id, dictionary), device)
        good = count > 0 and not problems
        failed += not good
        print(f"{'ok  ' if good else 'FAIL'} {name}: {count} data elements, {len(problems)} differ ({time.monotonic() - started:.1f} s)")
        for problem in problems[:20]:
            print(f"     {problem}", flush=True)
    print(f"{len(options.case or cases)} files, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
