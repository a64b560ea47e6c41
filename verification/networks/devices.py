"""The device descriptions that drawn networks are made of, and what is expected of a device of each."""
import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
SIZES = {0x0005: 1, 0x0006: 2, 0x0007: 4}
# A round of the self tests over this time: the tests of a device are not what is looked at, and cost most of a run.
INTERVAL_MS = 60000
CHAIN = "examples/emergency_stop"
SOURCES = {"relay": f"{CHAIN}/actuator.dcf", "sensor": f"{CHAIN}/sensor.dcf", "controller": f"{CHAIN}/controller.dcf",
           "io": "examples/networks/managed_faults/io.dcf", "guarded": "tests/simulator/scenarios/networks/guarded.dcf"}
# A relay that was built from another DCF: its SCT.
OTHER_RELAY = {"1301sub2": "60"}


class BadDevice(Exception):
    """A DCF that cannot be made."""


def with_value(text, section, value):
    """The DCF with another ParameterValue, which the section has."""
    begin = text.index(f"[{section}]")
    at = text.index("ParameterValue=", begin)
    return text[:at] + f"ParameterValue={value}" + text[text.index("\n", at):]


def with_parameters(text, donor):
    """A plain device's DCF with the device parameters (5F00h) of another one."""
    before, behind = text.split("[ManufacturerObjects]\n", 1)
    listed, rest = behind.split("[", 1)
    rows = [row for row in listed.splitlines() if "=0x" in row]
    rows = [f"SupportedObjects={len(rows) + 1}", *rows, f"{len(rows) + 1}=0x5F00"]
    parameters = donor[donor.index("[5F00]"):donor.index("[5F01]")]
    return before + "[ManufacturerObjects]\n" + "\n".join(rows) + "\n\n[" + rest.rstrip("\n") + "\n\n" + parameters


def sections_of(text):
    """Section, lower case -> its keys."""
    sections, current = {}, {}
    for line in text.splitlines():
        if line.startswith("["):
            current = sections.setdefault(line.strip()[1:-1].lower(), {})
        elif "=" in line and not line.startswith(";"):
            key, value = line.split("=", 1)
            current[key.strip()] = value.strip()
    return sections


class Description:
    """One kind of device: its DCF without a node-ID, and what it holds."""

    def __init__(self, text):
        self.text = text
        self.sections = sections_of(text)
        self.is_safety = bool(self._indices(0x1301, 0x1340))
        self.heartbeat_ms = self._number("1017") or 0
        self.safety = self._safety_objects() if self.is_safety else {}

    def _indices(self, first, last):
        return [index for index in range(first, last + 1) if f"{index:x}" in self.sections]

    def _number(self, section):
        keys = self.sections.get(section)
        if keys is None:
            return None
        text = keys.get("ParameterValue", keys.get("DefaultValue", "0"))
        return 0 if "$" in text else int(text, 0)

    def _entry(self, section):
        return self._number(section), SIZES[int(self.sections[section]["DataType"], 16)]

    def _safety_objects(self):
        """(index, sub) -> (value, bytes) of all that semantics 10 has compared."""
        objects = {(0x13FE, 0): self._entry("13fe")}
        if "1300" in self.sections:
            objects[(0x1300, 0)] = self._entry("1300")
        for index in self._indices(0x1301, 0x1340):
            for sub in range(7):
                objects[(index, sub)] = self._entry(f"{index:x}sub{sub}")
            mapping = index + 0x80
            for sub in range(self._number(f"{mapping:x}sub0") + 1):
                objects[(mapping, sub)] = self._entry(f"{mapping:x}sub{sub:x}")
            objects[(0x13FF, index - 0x1300)] = self._entry(f"13ffsub{index - 0x1300:x}")
        objects[(0x13FF, 0)] = self._entry("13ffsub0")
        return objects

    def identity(self, serial):
        """What 1000h and 1018h:01 to 04 of such a device are."""
        values = {(0x1000, 0): self._number("1000")}
        for sub in range(1, 4):
            values[(0x1018, sub)] = self._number(f"1018sub{sub}")
        values[(0x1018, 4)] = serial
        return values

    def dcf(self, serial):
        """The DCF of such a device with this serial number, which no signature covers."""
        begin = self.text.index("[1018sub4]")
        at = self.text.index("DefaultValue=", begin)
        return self.text[:at] + f"DefaultValue={serial}" + self.text[self.text.index("\n", at):]


class Catalogue:
    """Every kind of device with every node-ID, made when it is asked for."""

    def __init__(self, program, folder):
        self.program = program
        self.folder = folder
        self.made = {}
        self.texts = {name: (ROOT / path).read_text(encoding="utf-8") for name, path in SOURCES.items()}
        other = self.texts["relay"]
        for section, value in OTHER_RELAY.items():
            other = with_value(other, section, value)
        self.texts["other relay"] = other
        for name in ("io", "guarded"):
            self.texts[name] = with_parameters(self.texts[name], self.texts["relay"])
        for name, text in self.texts.items():
            self.texts[name] = with_value(with_value(text, "5F00sub4", INTERVAL_MS), "5F00sub5", INTERVAL_MS)

    def of(self, kind, node):
        """The description of a device of this kind at this node-ID, with signatures and digest that fit it."""
        if (kind, node) not in self.made:
            text = re.sub(r"(?m)^NodeID=.*$", f"NodeID={node}", self.texts[kind])
            if "[13FE]" in text:
                text = self._signed(text, f"{kind.replace(' ', '_')}_{node}")
            self.made[(kind, node)] = Description(text)
        return self.made[(kind, node)]

    def _signed(self, text, name):
        plain, done = self.folder / f"{name}.plain.dcf", self.folder / f"{name}.dcf"
        plain.write_text(text, encoding="utf-8")
        run = subprocess.run([str(self.program), "sign", str(plain), "--write", str(done)], capture_output=True,
                             text=True, check=False)
        if not done.exists():
            raise BadDevice(f"{plain}: it cannot be signed:\n{run.stdout}{run.stderr}")
        return done.read_text(encoding="utf-8")
