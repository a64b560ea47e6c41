"""The safety part of node_client.py: what the kernel refuses, and the configuration procedure."""
import time


def safety(session):
    """SO-1059 1.2: write all, read back, compare, declare; and what the kernel refuses."""
    kept = {(i, s): session.node.sdo.upload(i, s) for i in (0x1301, 0x1302) for s in range(1, 7)}
    for index in (0x1381, 0x1382):
        for sub in range(0, 3):
            kept[index, sub] = session.node.sdo.upload(index, sub)
    kept[0x13FF, 1], kept[0x13FF, 2] = (session.node.sdo.upload(0x13FF, sub) for sub in (1, 2))
    refused(session)
    procedure(session, kept)


def refused(session):
    """Abort codes of semantics 7."""
    cases = [("direction 3", 0x1301, 1, 3, 1, 0x06090030), ("transmission type 253", 0x1301, 4, 253, 1, 0x06090030),
             ("COB-ID while on", 0x1301, 5, 0x10B, 4, 0x06090030), ("mapping while on", 0x1381, 1, 0x20000108, 4, 0x06010000),
             ("1300h = 2", 0x1300, 0, 2, 1, 0x06090030), ("1341h", 0x1341, 0, 0, 1, 0x06020000),
             ("13C1h", 0x13C1, 0, 0, 1, 0x06020000), ("1303h, which is not there", 0x1303, 1, 0, 1, 0x06020000),
             ("1301h:07", 0x1301, 7, 0, 1, 0x06090011), ("constant 1301h:00", 0x1301, 0, 6, 1, 0x06010002),
             ("a safety variable", 0x2200, 1, 1, 1, 0x06010002), ("1301h:02 with 4 bytes", 0x1301, 2, 50, 4, 0x06070010)]
    for name, index, sub, value, size, right in cases:
        code = session.write(index, sub, value, size)
        session.check(f"{name}: {right:08X}", code == right, f"{code:08X}")
    session.write(0x1301, 1, 0, 1)
    session.check("an accepted write clears 13FEh", session.read(0x13FE, 0) == 0)
    off = [("COB-ID outside", 0x1301, 5, 0x181, 4, 0x06090030), ("even COB-ID 1", 0x1301, 5, 0x10C, 4, 0x06090030),
           ("COB-ID of SRDO 2", 0x1301, 5, 0x103, 4, 0x06090030), ("reserved bits", 0x1301, 5, 0x8000010B, 4, 0x06090030),
           ("mapping count not 0", 0x1381, 1, 0x23000108, 4, 0x06010000)]
    for name, index, sub, value, size, right in off:
        code = session.write(index, sub, value, size)
        session.check(f"{name}: {right:08X}", code == right, f"{code:08X}")
    session.write(0x1381, 0, 0, 1)
    for name, sub, value, size, right in (("unknown object mapped", 1, 0x77770108, 4, 0x06020000),
                                          ("an object that is no SRDO data", 1, 0x40050008, 4, 0x06040041),
                                          ("odd count", 0, 1, 1, 0x06040042)):
        code = session.write(0x1381, sub, value, size)
        session.check(f"{name}: {right:08X}", code == right, f"{code:08X}")
    code = session.write(0x13FE, 0, 0xA5, 1)
    session.check("A5h with a wrong signature: 06040043", code == 0x06040043, f"{code:08X}")


def procedure(session, kept):
    sdo = session.node.sdo
    for index in (0x1301, 0x1302):
        sdo.download(index, 1, b"\0")
        for sub in (2, 3, 4, 5, 6):
            sdo.download(index, sub, kept[index, sub])
        sdo.download(index + 0x80, 0, b"\0")
        for sub in (1, 2):
            sdo.download(index + 0x80, sub, kept[index + 0x80, sub])
        sdo.download(index + 0x80, 0, kept[index + 0x80, 0])
        sdo.download(0x13FF, index - 0x1300, kept[0x13FF, index - 0x1300])
        sdo.download(index, 1, kept[index, 1])
    same = all(sdo.upload(index, sub) == value for (index, sub), value in kept.items())
    session.check("written, read back, compared", same)
    since = session.command(1)
    told = session.wait_for(0x80 + session.id, since, lambda d: d[:2] == b"\x00\x63")
    session.check("OPERATIONAL without 13FEh = A5h: emergency 6300h", told is not None)
    code = session.write(0x13FE, 0, 0xA5, 1)
    session.check("A5h in OPERATIONAL: 08000022", code == 0x08000022, f"{code:08X}")
    session.sleep(0.2)
    session.check("no SRDO without a valid configuration", not session.heard(0x103, since))
    session.command(128)
    session.check("13FEh = A5h accepted", session.write(0x13FE, 0, 0xA5, 1) == 0 and session.read(0x13FE, 0) == 0xA5)
    since = session.command(1)
    pair = session.wait_for(0x103, since) and session.wait_for(0x104, since)
    session.check("SRDOs go out", pair is not None)
    for index, sub, size in ((0x1301, 2, 2), (0x1381, 0, 1), (0x13FF, 1, 2)):
        code = session.write(index, sub, session.read(index, sub), size)
        session.check(f"0x{index:X}:{sub:02X} in OPERATIONAL: 08000022", code == 0x08000022, f"{code:08X}")
    session.check("1300h in OPERATIONAL", session.write(0x1300, 0, session.read(0x1300, 0), 1) == 0)
    lost = session.wait_for(0x103, time.monotonic())
    session.check("still sending", lost is not None)
    session.command(128)
