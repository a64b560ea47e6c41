"""Runs images on QEMU: its Cortex-R5F with big-endian data, and boards with a Cortex-M."""
import dataclasses
import subprocess

COMMAND = ["qemu-system-arm", "-M", "none", "-m", "16M", "-cpu", "cortex-r5f", "-nographic", "-monitor", "none",
           "-serial", "none"]


@dataclasses.dataclass
class Run:
    """What came of one run: status is None when the time limit ended it."""
    status: int
    output: str


def run_image(binary, argument="run", seconds=1800, count_instructions=True, folder=None, files=None):
    """Runs one .bin. With `count_instructions` one cycle of the cycle counter is one instruction, exactly. Files that the
    image asks for are looked for in `folder`; `files` (path -> address) are loaded besides."""
    command = COMMAND + ["-device", f"loader,file={binary},addr=0,force-raw=on", "-semihosting-config",
                         f"enable=on,target=native,arg={argument}"]
    for path, address in (files or {}).items():
        command += ["-device", f"loader,file={path},addr={address:#x},force-raw=on"]
    if count_instructions:
        command += ["-icount", "shift=0"]
    return run_command(command, seconds, folder)


def run_board(board, image, argument="run", seconds=1800):
    """Runs one little-endian ELF file on a board that the emulator knows by name."""
    return run_command(["qemu-system-arm", "-M", board, "-nographic", "-monitor", "none", "-serial", "none", "-semihosting-config",
                        f"enable=on,target=native,arg={argument}", "-kernel", str(image)], seconds, None)


def run_command(command, seconds, folder):
    try:
        done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, timeout=seconds, check=False,
                              cwd=folder)
    except subprocess.TimeoutExpired as expired:
        return Run(None, (expired.stdout or b"").decode("utf-8", "replace"))
    return Run(done.returncode, (done.stdout + done.stderr).decode("utf-8", "replace"))
