#!/usr/bin/env python3
"""A CANopen slave on a stack of other origin: a LocalNode of python-canopen, a process that can be killed.

    third_party_slave.py --can ADDRESS --dcf FILE [--serial N] [--device-type N]

Its objects are those of the DCF with their defaults; what the DCF has as ParameterValue is for the manager to write.
It boots, obeys NMT, sends heartbeats as 1017h says, restores its defaults at the reset that follows 1011h.
"""
import argparse
import pathlib
import struct
import sys
import threading

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import canopen  # noqa: E402
from canopen.objectdictionary import ODVariable  # noqa: E402
from canopen.objectdictionary.eds import import_eds  # noqa: E402
from canopen.sdo import SdoAbortedError  # noqa: E402
from node_bus import open_bus  # noqa: E402

RESET_NODE, RESET_COMMUNICATION = 0x81, 0x82
INITIALISING, PRE_OPERATIONAL = 0, 0x80
WRONG_SIGNATURE = 0x08000020
SIGNATURES = {0x1010: b"save", 0x1011: b"load"}


def dictionary(dcf):
    """The objects of the file as they are before anybody has configured the device."""
    objects = import_eds(dcf, None)
    for entry in objects.values():
        for variable in [entry] if isinstance(entry, ODVariable) else entry.values():
            variable.value = None
    return objects


class Slave:
    """What an application adds to the stack: boot-up after a reset, and the signatures of 1010h and 1011h."""

    def __init__(self, address, objects):
        self.network = canopen.Network()
        self.network.bus = open_bus(address)
        self.network.connect()
        self.node = self.network.create_node(objects.node_id, objects)
        self.node.add_write_callback(self.check_signature)
        self.network.subscribe(0, self.on_nmt)
        self.saved = {}
        self.boot()

    def boot(self):
        """The stack sends no boot-up message and starts no heartbeat by itself."""
        self.node.nmt.stop_heartbeat()
        self.node.data_store = {index: dict(subs) for index, subs in self.saved.items()}
        self.node.nmt.send_command(INITIALISING)
        self.node.nmt.send_command(PRE_OPERATIONAL)

    def on_nmt(self, _identifier, data, _timestamp):
        command, node = struct.unpack_from("BB", data)
        if node in (0, self.node.id) and command in (RESET_NODE, RESET_COMMUNICATION):
            self.boot()

    def check_signature(self, index, data, **_):
        if index not in SIGNATURES:
            return
        if bytes(data) != SIGNATURES[index]:
            raise SdoAbortedError(WRONG_SIGNATURE)
        stored = {at: subs for at, subs in self.node.data_store.items() if at not in SIGNATURES}
        self.saved = {at: dict(subs) for at, subs in stored.items()} if index == 0x1010 else {}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--can", required=True)
    parser.add_argument("--dcf", required=True)
    parser.add_argument("--serial", type=lambda text: int(text, 0))
    parser.add_argument("--device-type", type=lambda text: int(text, 0))
    arguments = parser.parse_args()
    objects = dictionary(arguments.dcf)
    if arguments.serial is not None:
        objects[0x1018][4].default = arguments.serial
    if arguments.device_type is not None:
        objects[0x1000].default = arguments.device_type
    Slave(arguments.can, objects)
    threading.Event().wait()


if __name__ == "__main__":
    sys.exit(main())
