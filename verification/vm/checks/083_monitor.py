# counterpoint monitor on vcan0: a clean bus has no violation, planted ones are told with their cause, others' frames by name
# Needs: build/product/tools/counterpoint examples/emergency_stop/sensor.dcf examples/emergency_stop/controller.dcf
# Requirements: SRS_MON_017
import json
import pathlib
import re
import subprocess
import sys
import time

import can

subprocess.run(["/tools/ip", "link", "add", "dev", "vcan0", "type", "vcan"], check=True)
subprocess.run(["/tools/ip", "link", "set", "vcan0", "up"], check=True)
dcfs = []
for name in ("sensor", "controller"):
    # The emulated machine is slow: SCT 50 ms becomes a minute, SRVT 20 ms 200 ms, the refresh time 25 ms 1 s.
    text = pathlib.Path(f"/examples/emergency_stop/{name}.dcf").read_text(encoding="latin-1")
    for short, long in (("50", "60000"), ("20", "200"), ("25", "1000")):
        text = re.sub(rf"^ParameterValue={short}$", f"ParameterValue={long}", text, flags=re.MULTILINE)
    pathlib.Path(f"/tmp/{name}.dcf").write_text(text, encoding="latin-1")
    dcfs.append(f"/tmp/{name}.dcf")
bus = can.Bus(interface="socketcan", channel="vcan0", fd=True)


def send(identifier, data=b"", **fields):
    bus.send(can.Message(arbitration_id=identifier, data=data, is_extended_id=fields.pop("is_extended_id", False), **fields))


def pair(value):
    send(0x101, [value, 2])
    send(0x102, [255 - value, 253])
    time.sleep(0.02)


def watched(play):
    """What the monitor says of what is played."""
    monitor = subprocess.Popen(["/build/product/tools/counterpoint", "monitor", "--can", "vcan0", "--json", "--for", "12", "--dcf", *dcfs],
                               stdout=subprocess.PIPE, text=True)
    time.sleep(3)
    play()
    answer = json.loads(monitor.communicate(timeout=60)[0])
    return monitor.returncode, [violation["cause"] for violation in answer["violations"]], answer


def clean():
    for value in range(50):
        pair(value)
    send(0x001)
    pair(50)
    # No candidates, all of them
    send(0x102, [1], is_extended_id=True)
    send(0x102, [1, 2], is_fd=True)
    send(0x701, [5])
    pair(51)


def planted():
    pair(1)
    send(0x101, [1, 2])
    send(0x102, [0xFE, 0xFC])
    pair(2)
    send(0x101, [1])
    send(0x102, [0xFE])
    pair(3)
    send(0x101, [1, 2])
    send(0x101, [1, 2])
    send(0x102, [0xFE, 0xFD])
    pair(4)
    send(0x102, [0xFE, 0xFD])
    pair(5)
    send(0x101, is_remote_frame=True)
    pair(6)
    send(0x101, [1, 2])
    time.sleep(1)
    pair(7)
    send(0x001)
    time.sleep(2)


PLANTED = ["not inverse", "wrong length", "normal twice", "inverse first", "remote frame", "SRVT expired", "GFC not followed"]
status, causes, answer = watched(clean)
print("note:", answer["frames"], "frames of a clean bus,", causes or "no violation")
good = status == 0 and causes == [] and answer["frames"] == 52 * 2 + 4
status, causes, answer = watched(planted)
print("note:", ", ".join(causes))
good = good and status == 1 and causes == PLANTED
bus.shutdown()
sys.exit(0 if good else 1)
