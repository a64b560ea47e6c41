"""Symbols of collected objects, DATA/objects/<room>/*.o (as shipped) and DATA/objects_plain/<room>/*.o (not optimised)."""
import re
import subprocess

from common import CannotLook


class Symbol:
    def __init__(self, name, kind, binding, section, path):
        self.name = name
        self.kind = kind
        self.binding = binding
        self.defined = section != "UND"
        self.path = path


def room_objects(data, folder, room):
    objects = sorted((data / folder / room).glob("*.o"))
    if not objects:
        raise CannotLook(f"{folder}/{room}/*.o, objects of the room {room}")
    return objects


def symbols(path):
    output = subprocess.run(["readelf", "--wide", "--symbols", path], check=True, capture_output=True, text=True).stdout
    for line in output.splitlines():
        row = re.match(r"\s*\d+: [0-9a-f]+\s+\S+ (\w+)\s+(\w+)\s+\w+\s+(?:\[.*\]\s+)?(\w+) (\S+)", line)
        if row and row.group(2) in ("GLOBAL", "WEAK", "UNIQUE"):
            yield Symbol(row.group(4), row.group(1), row.group(2), row.group(3), path)


def sections(path):
    output = subprocess.run(["readelf", "--wide", "--section-headers", path], check=True, capture_output=True, text=True).stdout
    return re.findall(r"\] (\.[\w.]+)", output)


def demangle(name):
    return subprocess.run(["c++filt", name], check=True, capture_output=True, text=True).stdout.strip()
