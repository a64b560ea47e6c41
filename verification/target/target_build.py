"""Builds by CMake what is measured or run on the target."""
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
CERTIFIED_TARGETS = ["safety_core_comparator", "safety_core_kernel", "safety_core_selftest", "safety_core_crosslink", "hal_api", "channel_a", "channel_b"]
SERVICE_TARGETS = ["canopen_cia301", "canopen_cia302_network", "canopen_cia302_safety_gate", "canopen_cia302_flying_master", "canopen_start_up_cia302", "canopen_start_up_el6751", "canopen_start_up_plc_designer", "canopen_manager", "canopen_cia305", "canopen_device", "canopen_generated"]
JOBS = "2"


class BadInput(Exception):
    """The build failed; the text has its end."""


def run(*command):
    done = subprocess.run([str(part) for part in command], cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, check=False)
    if done.returncode != 0:
        tail = "\n".join(done.stdout.splitlines()[-40:])
        raise BadInput(f"{' '.join(map(str, command))}: exit status {done.returncode}\n{tail}")


def build_target(folder, optimise, targets):
    """Big-endian objects and images, by both compilers."""
    run("cmake", "-G", "Ninja", "-S", ROOT, "-B", folder, "--toolchain", ROOT / "cmake/toolchain-armeb.cmake",
        "-DCOUNTERPOINT_HOST=OFF", "-DCOUNTERPOINT_CHANNEL_B_COMPILER=clang++-19", f"-DCOUNTERPOINT_TARGET_OPTIMISE={optimise}")
    run("cmake", "--build", folder, "--parallel", JOBS, "--target", *targets)
    return folder


def build_preset(preset, targets, folder=None):
    """Objects and programs of a preset, in the folder that it names (build/<preset> unless told)."""
    folder = folder or ROOT / "build" / preset
    run("cmake", "--preset", preset)
    run("cmake", "--build", folder, "--parallel", JOBS, "--target", *targets)
    return folder
