#!/usr/bin/env python3
"""What the page of times says of small records: the rows as they were measured, and a gap for each thing that does not fit."""
import copy
import json
import pathlib
import tempfile
import unittest

import timing

HOST, TARGET = "ab" * 32, "cd" * 32
BENCH = {"digest": {"product": HOST, "target": TARGET}, "firmware": {"entry_points": {"FirmwareMain": [1500, 3000], "FirmwareInterrupt": [300, 512]}, "stack": {}},
         "rows": [{"id": "fw_cycle", "text": "dearest cycle", "unit": "instructions", "aim": 6000, "must": 8000, "measured": 7900, "kept": True, "verdict": "must"},
                  {"id": "code", "text": "bytes", "unit": "bytes", "aim": 1, "must": 2, "measured": 3, "kept": False, "verdict": "BROKEN"}]}
RUN = {"digest": TARGET, "firmware_cycles": {"quiet": [5000, 100, 800], "own_device_worst": [7900, 1200, 1600]},
       "stack": [{"entry": "Kernel::Start", "bytes": 400, "path": []}, {"entry": "Kernel::Cycle", "bytes": 1400, "path": [["Kernel::Cycle", 1400]]}]}
LOOPS = """constexpr unsigned kMany = 12U;
void Go()
{
    for (unsigned at = 0U; at < kMany; ++at)
    {
    }
}
"""


class Timing(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="timing_")
        self.addCleanup(scratch.cleanup)
        self.root = pathlib.Path(scratch.name)
        self.bench, self.run_record = copy.deepcopy(BENCH), copy.deepcopy(RUN)
        self.identity, self.code = {"digest": HOST, "target_digest": TARGET}, LOOPS

    def page(self):
        texts = {"build/bench/bench.json": self.bench, "build/target/target.json": self.run_record, "data/identity.json": self.identity}
        for name, record in texts.items():
            self.write(name, json.dumps(record))
        self.write("channel_a/loops.cpp", self.code)
        self.write(f"{timing.SCENARIOS}/own_device_worst.txt", "# All at once:\n# pairs and checks.\n1000 input 5\n")
        return timing.page_of(self.root, self.root / "data")

    def write(self, name, text):
        (self.root / name).parent.mkdir(parents=True, exist_ok=True)
        (self.root / name).write_text(text, encoding="utf-8")

    def expect(self, *gaps):
        self.assertEqual(self.page()[1], list(gaps))

    def test_rows_are_what_was_measured(self):
        page, gaps = self.page()
        self.assertEqual(gaps, [])
        self.assertEqual(page["cycles"], [{"scenario": "own_device_worst", "instructions": 7900, "cycles": 1200, "stack": 1600},
                                          {"scenario": "quiet", "instructions": 5000, "cycles": 100, "stack": 800}])
        self.assertEqual(page["how"], "All at once: pairs and checks.")
        self.assertEqual(page["main"], [1500, 3000])
        self.assertEqual([row["entry"] for row in page["stacks"]], ["Kernel::Cycle", "Kernel::Start"])
        self.assertEqual([row["id"] for row in page["budgets"]], ["fw_cycle"])
        self.assertEqual(page["loops"], [{"path": "channel_a/loops.cpp", "line": 4, "function": "Go", "head": "for (unsigned at = 0U; at < kMany; ++at)", "bound": "kMany", "number": 12}])

    def test_nothing_was_measured(self):
        for record in ("build/bench/bench.json", "build/target/target.json"):
            with self.subTest(record):
                self.page()
                (self.root / record).unlink()
                self.assertEqual(timing.page_of(self.root, self.root / "data")[1], ["timing: nothing was measured"])

    def test_no_scenario_was_measured(self):
        self.run_record["firmware_cycles"] = {}
        self.expect("timing: the dearest cycle is of no scenario, expected own_device_worst, which is built to be it")

    def test_other_objects(self):
        self.identity["digest"] = "12" * 32
        self.expect("timing: the bench, host, measured objects abababababababab, expected 1212121212121212")

    def test_bench_of_other_objects_on_the_target(self):
        self.bench["digest"]["target"] = "12" * 32
        self.expect("timing: the bench, target, measured objects 1212121212121212, expected cdcdcdcdcdcdcdcd")

    def test_run_of_other_objects(self):
        self.run_record["digest"] = "12" * 32
        self.expect("timing: the target run, measured objects 1212121212121212, expected cdcdcdcdcdcdcdcd")

    def test_another_scenario_is_dearer_than_the_worst(self):
        self.run_record["firmware_cycles"]["quiet"][0] = 7901
        self.expect("timing: the dearest cycle is of quiet, expected own_device_worst, which is built to be it")

    def test_stack_by_analysis(self):
        self.bench["firmware"]["entry_points"]["FirmwareInterrupt"][0] = 513
        self.expect("timing: FirmwareInterrupt needs 513 bytes of stack, expected at most 512")

    def test_stack_by_fill(self):
        self.run_record["firmware_cycles"]["quiet"][2] = 3001
        self.expect("timing: quiet used 3001 bytes of stack, expected at most 3000")

    def test_broken_budget(self):
        """Each that is one of time or stack on the target; another one is none of this page."""
        for name in ("fixed", "fw_cycle", "fw_stack_a", "fw_stack_b", "fixed_target", "load", "services"):
            with self.subTest(name):
                self.bench["rows"][0].update(id=name, measured=8001, kept=False, verdict="BROKEN")
                self.expect("timing: dearest cycle: 8001 instructions, must be at most 8000")

    def test_known_gap_is_none_of_this_page(self):
        self.bench["rows"][0].update(measured=8001, kept=False, verdict="KNOWN GAP", known=True)
        self.expect()

    def test_loop_without_a_bound(self):
        self.code = "void Go()\n{\n    for (;;)\n    {\n    }\n}\n"
        self.expect("timing: channel_a/loops.cpp:3: a loop without a bound")


if __name__ == "__main__":
    unittest.main()
