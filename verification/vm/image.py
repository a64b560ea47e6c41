"""Makes what the virtual machine boots: Debian's kernel, and an initial RAM disk of our own.

The RAM disk is two archives, one behind the other, as the kernel takes them: the base (BusyBox, iproute2, kernel modules,
Python with the packages of requirements.txt that CANopen clients need), which is kept, and the load of one run (checks,
programs, files), which is small. Nothing is installed, nothing is mounted, no rights are needed.
"""
import hashlib
import pathlib
import re
import shutil
import stat
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
BUILD = ROOT / "build/vm"
# Loaded at boot, with what they need.
MODULES = ["vcan", "vxcan", "can-raw", "can-bcm", "can-gw", "kvaser_pci", "usb_8dev", "vhci-hcd", "slcan"]
# Packages that a check may import, with what they import.
PYTHON_PACKAGES = ["canopen", "can", "packaging", "typing_extensions.py", "wrapt"]
TOOLS = ["ip"]
LEFT_OUT = shutil.ignore_patterns("test", "tests", "__pycache__", "site-packages", "dist-packages", "idlelib", "ensurepip",
                                  "lib2to3", "tkinter", "turtledemo", "config-*", "pydoc_data", "*.a")


class CannotMake(Exception):
    """The image cannot be made; the text says what was expected."""


def output_of(command, **more):
    """What a command prints; CannotMake with its last words when it fails."""
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False, **more)
    if done.returncode != 0:
        last = (done.stderr or done.stdout).strip().splitlines()[-1:] or ["it said nothing"]
        raise CannotMake(f"{' '.join(map(str, command))}: {last[0]}")
    return done.stdout


def tool(name):
    """Where a program is; sbin is not on everybody's path."""
    for folder in [None, "/usr/sbin", "/sbin"]:
        path = shutil.which(name, path=folder)
        if path:
            return path
    raise CannotMake(f"{name} is not installed, expected it from the packages that ./dev vm installs")


def kernel():
    """The folder with Debian's newest kernel, unpacked; downloaded once."""
    depends = output_of(["apt-cache", "depends", "linux-image-amd64"])
    found = re.search(r"Depends: (linux-image-(\S+))", depends)
    if not found:
        raise CannotMake("linux-image-amd64: no kernel found among what it depends on, expected apt-get update to have run")
    package, release = found.groups()
    folder = BUILD / f"kernel-{release}"
    if not (folder / "done").exists():
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        print(f"Downloading {package}", flush=True)
        output_of(["apt-get", "download", package], cwd=folder)
        archive = next(folder.glob("*.deb"))
        output_of(["dpkg-deb", "-x", archive.name, "."], cwd=folder)
        archive.unlink()
        output_of([tool("depmod"), "-b", str(folder), release])
        (folder / "done").write_text(release + "\n", encoding="utf-8")
    return folder, release


def libraries(program):
    """The shared libraries of a program; none of a static one."""
    done = subprocess.run(["ldd", str(program)], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, check=False)
    return re.findall(r"(?:=> )?(/\S+) \(0x", done.stdout)


def place(source, target):
    """Copies a file, followed through links, with the libraries it needs at their own places."""
    source = pathlib.Path(source)
    target.parent.mkdir(parents=True, exist_ok=True)
    if not target.exists():
        shutil.copy2(source, target)
    return [pathlib.Path(library) for library in libraries(source)]


def place_with_libraries(root, source, inside):
    for library in place(source, root / inside):
        place(library, root / str(library).lstrip("/"))


def modules(folder, release, names):
    """Paths of modules in the order in which they are loaded."""
    paths = []
    for name in names:
        shown = output_of([tool("modprobe"), "-d", str(folder), "-S", release, "--show-depends", name])
        for path in re.findall(r"^insmod (\S+)", shown, re.MULTILINE):
            if path not in paths:
                paths.append(path)
    return [pathlib.Path(path) for path in paths]


def place_python(root, python):
    """The interpreter, its library and the packages, under /python; guest_init.sh says where the packages are."""
    asked = "import os, sys, sysconfig; print(os.path.realpath(sys._base_executable)); print(sysconfig.get_paths()['stdlib']);" \
            "print(sysconfig.get_paths()['purelib']); print('%d.%d' % sys.version_info[:2])"
    program, library, packages, version = output_of([python, "-c", asked]).split()
    base_library = output_of([program, "-c", "import sysconfig; print(sysconfig.get_paths()['stdlib'])"]).strip() or library
    place_with_libraries(root, program, "python/bin/python3")
    target = root / f"python/lib/python{version}"
    shutil.copytree(base_library, target, ignore=LEFT_OUT, symlinks=False, dirs_exist_ok=True, ignore_dangling_symlinks=True)
    for extension in target.glob("lib-dynload/*.so"):
        for needed in libraries(extension):
            place(needed, root / str(needed).lstrip("/"))
    # A folder of their own: where an interpreter looks by itself differs from Debian's to others.
    own = root / "python/packages"
    own.mkdir(parents=True)
    for name in PYTHON_PACKAGES:
        source = pathlib.Path(packages) / name
        if not source.exists():
            raise CannotMake(f"{source} is not there, expected the packages of requirements.txt in .venv")
        if source.is_dir():
            shutil.copytree(source, own / name, ignore=LEFT_OUT)
        else:
            shutil.copy2(source, own / name)
    # Compiled here, because the emulated machine takes seconds for it.
    output_of([program, "-m", "compileall", "-q", "-s", str(root), "-p", "/", str(target), str(own)])


def archive(folder, path):
    """A folder as an archive of the form that the kernel unpacks."""
    names = sorted(str(item.relative_to(folder)) for item in folder.rglob("*"))
    with open(path, "wb") as file:
        subprocess.run([tool("cpio"), "--quiet", "-o", "-H", "newc", "-R", "0:0"], cwd=folder, input="\n".join(names).encode(),
                       stdout=file, check=True)


def base(python):
    """The kernel's file and the base archive, made again when what it is made of changed."""
    folder, release = kernel()
    asked = [pathlib.Path(__file__).read_text(encoding="utf-8"), (HERE / "guest_init.sh").read_text(encoding="utf-8"),
             (ROOT / "requirements.txt").read_text(encoding="utf-8"), release, output_of([python, "-VV"])]
    mark = hashlib.sha256("\n".join(asked).encode()).hexdigest()
    path, mark_path = BUILD / "base.cpio", BUILD / "base.mark"
    if not (path.exists() and mark_path.exists() and mark_path.read_text(encoding="utf-8") == mark):
        root = BUILD / "base"
        shutil.rmtree(root, ignore_errors=True)
        for name in ["bin", "dev", "proc", "sys", "tmp", "run", "etc", "modules"]:
            (root / name).mkdir(parents=True)
        place(tool("busybox"), root / "bin/busybox")
        for name in TOOLS:
            place_with_libraries(root, tool(name), f"tools/{name}")
        order = modules(folder, release, MODULES)
        for source in order:
            place(source, root / "modules" / source.name)
        (root / "modules/order").write_text("".join(f"{source.name}\n" for source in order), encoding="utf-8")
        place_python(root, python)
        init = root / "init"
        shutil.copy(HERE / "guest_init.sh", init)
        init.chmod(init.stat().st_mode | stat.S_IXUSR | stat.S_IXGRP | stat.S_IXOTH)
        archive(root, path)
        shutil.rmtree(root)
        mark_path.write_text(mark, encoding="utf-8")
    return folder / f"boot/vmlinuz-{release}", path


def load(checks, build):
    """The archive of one run: the checks, what they need, and the shell functions that they share. Programs of
    build/product come from `build`."""
    root = BUILD / "load"
    shutil.rmtree(root, ignore_errors=True)
    (root / "checks").mkdir(parents=True)
    shutil.copy(HERE / "guest_lib.sh", root / "lib.sh")
    for helper in sorted(HERE.glob("guest_*.py")):
        shutil.copy(helper, root / helper.name)
    for check in checks:
        shutil.copy(check.path, root / "checks" / check.path.name)
        for name in check.needs:
            source = ROOT / re.sub(r"^build/product(?=/)", build, name)
            if not source.exists():
                raise CannotMake(f"{check.path.relative_to(ROOT)}: needs {source.relative_to(ROOT)}, which is not there")
            if source.is_dir():
                shutil.copytree(source, root / name, dirs_exist_ok=True)
            else:
                place_with_libraries(root, source, name)
    plan = "".join(f"{check.path.name} {check.seconds}\n" for check in checks)
    (root / "checks/plan").write_text(plan, encoding="utf-8")
    path = BUILD / "load.cpio"
    archive(root, path)
    shutil.rmtree(root)
    return path


def python_of(root):
    """The Python whose packages are used: .venv of ./dev, else the running one."""
    own = root / ".venv/bin/python"
    return str(own) if own.exists() else sys.executable
