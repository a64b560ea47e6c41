"""A serial-line CAN adapter made of software, for checks in the virtual machine: Linux's own driver slcan drives it.

The driver has no restart of its own, so bus-off ends only when the interface is taken down and up.
Orders, one a file /tmp/serial.orders, taken away when carried out: busoff | active
"""
import fcntl
import os
import pathlib
import pty
import select
import struct
import termios
import tty

ORDERS = pathlib.Path("/tmp/serial.orders")
SERIAL_CAN = 17
STATES = {"busoff": b"sb256256\r", "active": b"sa000000\r"}


def main():
    own, line = pty.openpty()
    tty.setraw(line)
    tty.setraw(own)
    fcntl.ioctl(line, termios.TIOCSETD, struct.pack("i", SERIAL_CAN))
    while True:
        if select.select([own], [], [], 0.01)[0]:
            os.read(own, 4096)
        elif ORDERS.exists():
            os.write(own, STATES[ORDERS.read_text(encoding="ascii").strip()])
            ORDERS.unlink()


if __name__ == "__main__":
    main()
