"""Writes a drawn network as the files that `counterpoint simulate` reads: JSON, which is YAML."""
import json


def microseconds(value):
    return f"{value} us"


def event_entry(event):
    entry = {"at": microseconds(event["at_us"]), "do": event["do"]}
    for key in ("node", "serial", "identifier", "order", "value"):
        if key in event:
            entry[key] = event[key]
    for key in ("until", "every"):
        if key + "_us" in event:
            entry[key] = microseconds(event[key + "_us"])
    if "data" in event:
        entry["data"] = event["data"].hex(" ").upper()
    if "key" in event:
        entry["object"] = f"0x{event['key'][0]:04X}:{event['key'][1]:02X}"
    return entry


def network_document(plan):
    slaves = []
    for slave in plan.slaves:
        entry = {"node": slave.node, "dcf": f"slave_{slave.node}.dcf", **slave.entry}
        if not slave.expects_serial:
            entry["serial"] = 0
        slaves.append(entry)
    return {"name": f"Network {plan.number}", "manager": plan.manager, "slaves": slaves}


def scenario_document(plan):
    nodes = {str(slave.node): {"dcf": f"device_{slave.node}.dcf", "serial": slave.device_serial,
                               "phase": microseconds(slave.comes_us)} for slave in plan.slaves if slave.is_there}
    document = {"title": f"Network {plan.number}, profile {plan.profile}", "bitrate": plan.bitrate,
                "duration": microseconds(plan.duration_us), "managers": [{"network": "network.yaml"}],
                "nodes": nodes, "events": [event_entry(event) for event in plan.events],
                "expect": [{"that": "device", "node": node, "is": "operational"} for node in nodes]}
    return {key: value for key, value in document.items() if value not in ([], {})}


def dump(document):
    """JSON, a list's entries one a line, so that a line number says which one is meant."""
    parts = []
    for key, value in document.items():
        if isinstance(value, list):
            rows = ",\n  ".join(json.dumps(item) for item in value)
            parts.append(f"{json.dumps(key)}: [\n  {rows}]")
        else:
            parts.append(f"{json.dumps(key)}: {json.dumps(value)}")
    return "{" + ",\n".join(parts) + "}\n"


def write(plan, catalogue, folder):
    """All files of a plan; the scenario's path."""
    for slave in plan.slaves:
        expected, device = catalogue.of(slave.kind, slave.node), catalogue.of(slave.device_kind, slave.node)
        (folder / f"slave_{slave.node}.dcf").write_text(expected.dcf(slave.serial), encoding="utf-8")
        (folder / f"device_{slave.node}.dcf").write_text(device.dcf(slave.device_serial), encoding="utf-8")
    (folder / "network.yaml").write_text(dump(network_document(plan)), encoding="utf-8")
    path = folder / "scenario.yaml"
    path.write_text(dump(scenario_document(plan)), encoding="utf-8")
    return path
