"""A bus of `counterpoint node` for python-can: the datagrams of hal/host/live/udp_bus.cpp, or python-can's own interfaces."""
import os
import select
import socket
import struct
import time

import can

HEAD = struct.Struct(">4s8sBBI")
MAGIC = b"CPB1"
EXTENDED, REMOTE, FD = 1, 2, 4


class UdpBus(can.BusABC):
    """The virtual bus `udp:GROUP:PORT` of this machine. Own frames are not received."""

    def __init__(self, group, port):
        super().__init__(channel=f"udp:{group}:{port}")
        self.target = (group, port)
        self.sender = os.urandom(8)
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4 * 1024 * 1024)
        self.socket.bind(self.target)
        loopback = socket.inet_aton("127.0.0.1")
        member = socket.inet_aton(group) + loopback
        self.socket.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, member)
        self.socket.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, loopback)
        self.socket.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, 0)

    def send(self, msg, timeout=None):
        flags = (EXTENDED if msg.is_extended_id else 0) | (REMOTE if msg.is_remote_frame else 0)
        data = b"" if msg.is_remote_frame else bytes(msg.data)
        self.socket.sendto(HEAD.pack(MAGIC, self.sender, flags, msg.dlc, msg.arbitration_id) + data, self.target)

    def _recv_internal(self, timeout):
        end = None if timeout is None else time.monotonic() + timeout
        while True:
            left = None if end is None else max(0.0, end - time.monotonic())
            if not select.select([self.socket], [], [], left)[0]:
                return None, False
            message = self.parse(self.socket.recv(256))
            if message is not None:
                return message, False

    def parse(self, datagram):
        if len(datagram) < HEAD.size or datagram[:4] != MAGIC:
            return None
        _, sender, flags, length, identifier = HEAD.unpack_from(datagram)
        if sender == self.sender or flags & FD:
            return None
        return can.Message(timestamp=time.time(), arbitration_id=identifier, dlc=length, data=datagram[HEAD.size:],
                           is_extended_id=bool(flags & EXTENDED), is_remote_frame=bool(flags & REMOTE))

    def fileno(self):
        return self.socket.fileno()

    def shutdown(self):
        super().shutdown()
        self.socket.close()


def open_bus(address):
    """The address forms of `counterpoint node --can`."""
    kind, _, rest = address.partition(":")
    if kind == "udp":
        group, port = rest.split("?")[0].split(":")
        return UdpBus(group, int(port))
    if kind == "socketcand":
        where, channel = rest.split("/")
        host, port = where.split(":")
        return can.Bus(interface="socketcand", host=host, port=int(port), channel=channel)
    return can.Bus(interface="socketcan", channel=rest or kind)
