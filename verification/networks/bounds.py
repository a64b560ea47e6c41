"""How long a manager may take, from what its network file says."""
MS = 1000
FRAME_BITS = 160
SDO_TIMES = {"cia302": (500, 3), "el6751": (2000, 1), "plc_designer": (500, 1)}  # docs/manager.md: silence, tries
AGAIN_MS = {"cia302": 1000, "el6751": 0, "plc_designer": 2500}  # Until who is silent is asked anew.
COMMANDS = 4  # That wait for one slave: stop, reset, PRE-OPERATIONAL, start.
NODES = 127
TRANSFERS = 80  # More than the SDOs of any drawn slave, verification and its repetition included.
SLACK_MS = 500


def milliseconds(text):
    return int(text.split()[0])


def silence_us(plan):
    """An SDO that nobody answers any more."""
    timeout_ms, tries = SDO_TIMES[plan.profile]
    return timeout_ms * tries * MS


def supervision_us(slave):
    """Until the manager has seen that a slave is silent."""
    entry = slave.entry
    if "guard_time" in entry:
        return milliseconds(entry["guard_time"]) * entry["retry_factor"] * MS
    heartbeat = milliseconds(entry.get("heartbeat", "100 ms"))
    return milliseconds(entry.get("consumer", f"{2 * heartbeat} ms")) * MS


def inhibit_us(plan):
    """Between two NMT commands."""
    return milliseconds(plan.manager.get("inhibit", "0 ms")) * MS


def queue_us(plan):
    """Until all commands that wait have left: with slaves that are kept alive each other node is reset by itself."""
    is_single = any(slave.entry.get("keep_alive") for slave in plan.slaves)
    return inhibit_us(plan) * (COMMANDS * len(plan.slaves) + (NODES if is_single else 0))


def talk_us(plan):
    """All SDOs of all slaves, one after the other."""
    frame_us = FRAME_BITS * 1000000 // plan.bitrate
    return len(plan.slaves) * TRANSFERS * (2 * frame_us + MS)


def rest_us(plan):
    """From the last fault to the instant at which every healthy slave runs: what is under way ends in silence, the loss is
    seen, the slave is waited for and asked anew, and configured."""
    seen = max(supervision_us(slave) for slave in plan.slaves)
    return 2 * silence_us(plan) + seen + AGAIN_MS[plan.profile] * MS + talk_us(plan) + queue_us(plan) + SLACK_MS * MS


def stop_us(plan, node):
    """From the first sign of a safety slave that runs with another configuration to the command that stops it: its second
    heartbeat, an SDO that is not answered, the reading, and one inhibit time for itself and for each such stop before it."""
    stops_us = inhibit_us(plan) * len(plan.safety_nodes)
    return 2 * supervision_us(plan.slave(node)) + silence_us(plan) + talk_us(plan) + stops_us + SLACK_MS * MS
