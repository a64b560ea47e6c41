#!/usr/bin/env python3
"""The table of interfaces of a small tree: what rooms declare, what they include, what headers offer, and what is not declared."""
import pathlib
import tempfile
import unittest

import interfaces

TREE = {
    "safety_core/contract/CMakeLists.txt": "counterpoint_room(safety_core_contract INTERFACE DEPENDS)\n",
    "safety_core/contract/frame.hpp": "namespace counterpoint\n{\nenum class Kind : int\n{\n    kData,\n};\nclass Frame\n{\n  public:\n    struct Part\n    {\n    };\n};\nint LengthOf(const Frame& frame) noexcept;\n}\n",
    "safety_core/contract/limits.hpp": "namespace counterpoint\n{\nconstexpr int kMost = 64;\n}\n",
    "hal/api/CMakeLists.txt": "# counterpoint_room(of_a_comment DEPENDS nobody)\ncounterpoint_room(hal_api KERNEL\n  SOURCES port.cpp\n  DEPENDS safety_core_contract)\n",
    "hal/api/port.hpp": '#include "safety_core/contract/frame.hpp"\nclass Port\n{\n};\n',
    "channel_a/CMakeLists.txt": "counterpoint_room(channel_a KERNEL SOURCES a.cpp DEPENDS hal_api)\n",
    "channel_a/a.cpp": '#include "channel_a/a.hpp"\n#include "hal/api/port.hpp"\n#include "safety_core/contract/limits.hpp"\n',
    "channel_a/a.hpp": "class A\n{\n};\n",
}


class Interfaces(unittest.TestCase):
    def page(self, **changes):
        with tempfile.TemporaryDirectory(prefix="interfaces_") as scratch:
            root = pathlib.Path(scratch)
            for name, text in {**TREE, **changes}.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text, encoding="utf-8")
            return interfaces.page_of(root)

    def test_rooms_with_their_headers(self):
        page, gaps = self.page()
        self.assertEqual(gaps, [])
        self.assertEqual(page["rooms"], ["channel_a", "hal/api", "safety_core/contract"])
        self.assertEqual(page["rows"], [
            {"room": "channel_a", "other": "hal/api", "headers": ["hal/api/port.hpp"], "declared": True},
            {"room": "channel_a", "other": "safety_core/contract", "headers": ["safety_core/contract/limits.hpp"], "declared": False},
            {"room": "hal/api", "other": "safety_core/contract", "headers": ["safety_core/contract/frame.hpp"], "declared": True}])

    def test_what_headers_offer_and_to_whom(self):
        page, _ = self.page()
        self.assertEqual(page["offers"], {"hal/api/port.hpp": ["Port"], "safety_core/contract/frame.hpp": ["Frame", "Kind", "LengthOf"], "safety_core/contract/limits.hpp": []})
        self.assertEqual(page["users"], {"hal/api/port.hpp": ["channel_a"], "safety_core/contract/frame.hpp": ["hal/api"], "safety_core/contract/limits.hpp": ["channel_a"]})

    def test_declared_and_not_included(self):
        page, gaps = self.page(**{"channel_a/a.cpp": ""})
        self.assertEqual(gaps, [])
        self.assertIn({"room": "channel_a", "other": "hal/api", "headers": [], "declared": True}, page["rows"])

    def test_included_and_not_declared_is_a_gap(self):
        gaps = self.page(**{"hal/api/port.hpp": '#include "channel_a/a.hpp"\n'})[1]
        self.assertEqual(gaps, ["interfaces: hal/api includes channel_a/a.hpp of channel_a, which it does not declare"])


if __name__ == "__main__":
    unittest.main()
