#!/usr/bin/env python3
"""Each check, warning, option and gate that the MISRA plan names for a guideline finds the sample of that guideline which
breaks it, and says nothing of the one that does not."""
import concurrent.futures
import pathlib
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import CannotLook, read, run_gate  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
GATES = HERE.parent
PLAN = "MISRA/compliance_plan.md"
SAMPLES = "MISRA/confirmation"
ROW = re.compile(r"^\| ((?:D )?\d+\.\d+\.\d+) \| \w+ \| \w+ \| (.*) \|$", re.MULTILINE)
MEAN = re.compile(r"(clang-tidy|warning|compiler|gate) `([^`]+)`")
HEAD = re.compile(MEAN.pattern + r"(?: as `([\w-]+)`)?$")
CODE = re.compile(r"(fires|quiet)( guarded)?( header)?:$")
# Gates that are run here over the samples; any other one has its own fixture, which the sample names.
RUN = ("clang_tidy", "cppcheck", "includes", "tokens")
COMPILERS = ("g++-12", "clang++-19")


class Sample:
    """What confirms one mean of one guideline."""

    def __init__(self, where, guideline, head):
        self.where, self.guideline = where, guideline
        self.kind, self.name, self.tells = head.groups()
        self.mean = f"{self.kind} `{self.name}`"
        self.code, self.form, self.fixture = {}, {}, None

    def gate(self):
        """The gate that runs the check, or None where a compiler does."""
        return {"clang-tidy": "clang_tidy", "warning": "clang_tidy", "gate": self.name}.get(self.kind)

    def is_told(self, text):
        """Whether this finding is the one that the plan names."""
        check = {"clang-tidy": self.name, "warning": "clang-diagnostic-" + (self.tells or self.name[2:])}.get(self.kind)
        return check is None or any(word.startswith(check) for word in re.split(r"[\[\],]", text))

    def file(self, number, part):
        header = "header" in self.form[part]
        return f"channel_a/s{number}_{part}.{'hpp' if header else 'cpp'}"

    def text(self, number, part):
        if "guarded" not in self.form[part]:
            return self.code[part]
        guard = re.sub(r"[^A-Z0-9]", "_", self.file(number, part).upper())
        return f"#ifndef {guard}\n#define {guard}\n{self.code[part]}\n#endif\n"


def parse(root, path):
    """The samples of one file; what is written wrongly comes as findings."""
    name, samples, findings, part = path.relative_to(root).as_posix(), [], [], None
    guideline = path.stem.replace("D_", "D ")
    for number, line in enumerate(path.read_text().splitlines(), start=1):
        head, code = HEAD.match(line), CODE.match(line)
        if head:
            samples.append(Sample(f"{name}:{number}", guideline, head))
            part = None
        elif code and samples:
            part = code.group(1)
            samples[-1].code[part] = ""
            samples[-1].form[part] = (code.group(2) or "") + (code.group(3) or "")
        elif line.startswith("fixture: ") and samples:
            samples[-1].fixture = line.split(": ", 1)[1]
        elif part and (line.startswith("    ") or not line):
            samples[-1].code[part] += line[4:] + "\n"
        elif line:
            findings.append(f"{name}:{number}: '{line}', expected a mean of the plan, 'fires:', 'quiet:', 'fixture:' or code behind four blanks")
    return samples, findings


def compare_with_plan(root, samples):
    """Each mean that the plan names has a sample, each sample a mean."""
    planned = {(row.group(1), mean.group(0)): PLAN for row in ROW.finditer(read(root, PLAN)) for mean in MEAN.finditer(row.group(2))}
    if not planned:
        raise CannotLook(f"no row of {PLAN} names a check")
    shown = {}
    for sample in samples:
        key = (sample.guideline, sample.mean)
        if key in shown:
            yield f"{sample.where}: {sample.mean} stands twice for {sample.guideline}"
        if key not in planned:
            yield f"{sample.where}: {PLAN} does not name {sample.mean} for {sample.guideline}"
        shown[key] = sample
        if not sample.fixture and set(sample.code) != {"fires", "quiet"}:
            yield f"{sample.where}: expected one sample that fires and one that is quiet, or a fixture"
    for guideline, mean in planned:
        if (guideline, mean) not in shown:
            yield f"{PLAN}:1: {guideline}: nothing in {SAMPLES} confirms {mean}"


def check_fixture(sample):
    case = GATES / sample.name / "fixture" / sample.fixture
    if sample.kind != "gate" or sample.name in RUN:
        yield f"{sample.where}: a fixture for {sample.mean}, expected code that is tried"
    elif not (case / "expected").exists():
        yield f"{sample.where}: gate {sample.name} has no fixture {sample.fixture} that it must refuse"


def run_over(gate, samples):
    """One run of a gate of the tree over all samples that it has to judge."""
    findings = []
    with tempfile.TemporaryDirectory(prefix="confirmation_") as scratch:
        made = pathlib.Path(scratch)
        (made / "channel_a").mkdir()
        for number, sample in enumerate(samples):
            for part in sample.code:
                (made / sample.file(number, part)).write_text(sample.text(number, part))
        done = subprocess.run([sys.executable, GATES / gate / "gate.py", made, made], capture_output=True, text=True, check=False)
    if done.returncode not in (0, 1):
        raise CannotLook(f"gate {gate} over the samples: exit status {done.returncode}: {(done.stdout + done.stderr)[-300:]}")
    told = [line.split(":", 1) for line in done.stdout.splitlines() if ":" in line]
    for number, sample in enumerate(samples):
        for part in sample.code:
            texts = [text for name, text in told if name == sample.file(number, part)]
            findings += judge(sample, part, any(sample.is_told(text) for text in texts), "; ".join(texts))
    return findings


def judge(sample, part, is_told, texts):
    if part == "fires" and not is_told:
        return [f"{sample.where}: {sample.guideline}: {sample.mean} does not find the sample that breaks the guideline; told: {texts or 'nothing'}"]
    if part == "quiet" and is_told:
        return [f"{sample.where}: {sample.guideline}: {sample.mean} finds something in the sample that keeps the guideline: {texts}"]
    return []


def options():
    """What every object of the certified part is compiled with, what the tree adds to it (-Werror) included."""
    room = (GATES.parents[1] / "cmake/Room.cmake").read_text()
    found = []
    for name in ("COUNTERPOINT_WARNINGS", "COUNTERPOINT_KERNEL_FLAGS"):
        found += re.search(rf"set\({name} ([^)]*)\)", room).group(1).split()
        found += [word for words in re.findall(rf"list\(APPEND {name} ([^)]*)\)", room) for word in words.split()]
    return ["-std=c++17", *found]


def compile_text(compiler, text, flags):
    """(whether it is refused, what the compiler told)"""
    command = [compiler, *flags, "-O1", "-x", "c++", "-c", "-o", "/dev/null", "-"]
    done = subprocess.run(command, input=text, capture_output=True, text=True, check=False)
    return done.returncode != 0, done.stderr


def without(flags, name):
    """The options as if this one were not there; a standard gives way to a later one."""
    return [flag for flag in flags if flag != name] + (["-std=c++20"] if name.startswith("-std=") else [])


def run_compilers(sample):
    """Refused by both compilers because of this option, which they name or without which it compiles; and the other sample by none."""
    flags = options()
    for compiler in COMPILERS:
        is_refused, told = compile_text(compiler, sample.code["fires"], flags)
        is_named = sample.name.startswith("-W") and re.search(rf"[=W]{re.escape(sample.name[2:])}\]", told)
        if not is_refused or not (is_named or not compile_text(compiler, sample.code["fires"], without(flags, sample.name))[0]):
            yield f"{sample.where}: {sample.guideline}: {sample.mean} of {compiler} does not refuse the sample that breaks the guideline"
        is_refused, told = compile_text(compiler, sample.code["quiet"], flags)
        if is_refused:
            yield f"{sample.where}: {sample.guideline}: {compiler} refuses the sample that keeps the guideline: {told[:200]}"


def gate(root, _data):
    if not (root / PLAN).exists():
        raise CannotLook(f"{PLAN} is not there")
    samples, findings = [], []
    for path in sorted((root / SAMPLES).glob("*.txt")):
        found, wrong = parse(root, path)
        samples += found
        findings += wrong
    findings += compare_with_plan(root, samples)
    whole = [sample for sample in samples if set(sample.code) == {"fires", "quiet"}]
    for sample in samples:
        if sample.fixture:
            findings += check_fixture(sample)
        elif sample.kind == "gate" and sample.name not in RUN:
            findings.append(f"{sample.where}: {sample.mean} is not run here, expected 'fixture:' with a case of its own")
    with concurrent.futures.ThreadPoolExecutor(max_workers=2) as pool:
        groups = {name: [sample for sample in whole if sample.gate() == name] for name in RUN}
        runs = [pool.submit(run_over, name, group) for name, group in groups.items() if group]
        runs += [pool.submit(lambda one: list(run_compilers(one)), sample) for sample in whole if sample.kind == "compiler"]
        for run in runs:
            findings += run.result()
    return findings, f"{len(samples)} samples of {len({sample.guideline for sample in samples})} guidelines"


run_gate(gate)
