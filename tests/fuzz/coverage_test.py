"""The measure of coverage, on a made-up export and page."""

import json
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "coverage"))
from lines import add_export  # noqa: E402
from page import below_goal, page, table  # noqa: E402
from reasons import read_reasons  # noqa: E402

# template <class T>            1
# int sign(T x) {               2   region, all of the function
#   if (x < 0) {                3   condition at column 7
#     return -1;                4
#   }                           5
#   return kSigned ? 1 : 0;     6   condition at column 10, folded
# }                             7
SOURCE = "template <class T>\nint sign(T x) {\n  if (x < 0) {\n    return -1;\n  }\n  return kSigned ? 1 : 0;\n}\n"


def export(negative: int, positive: int, file: str = "/r/core/graze/sign.hpp") -> str:
    times = negative + positive
    segments = [[2, 15, times, True, True, False], [3, 7, times, True, True, False], [3, 14, negative, True, True, False],
                [5, 4, positive, True, False, False], [7, 2, 0, False, False, False]]
    branches = [[3, 7, 3, 12, negative, positive, 0, 0, 4], [6, 10, 6, 17, 0, 0, 0, 0, 4]]
    return json.dumps({"data": [{"files": [{"filename": file, "segments": segments, "branches": branches}]}]})


class Coverage(unittest.TestCase):
    def setUp(self):
        self.files = {}

    def test_a_line_and_an_outcome_that_never_were(self):
        add_export(export(0, 5), "/r/core/graze/", self.files)
        one = self.files["sign.hpp"]
        self.assertEqual(one.missed_lines(), [4, 5])
        self.assertEqual(one.missed_branches(), [((3, 7, 3, 12), True)])
        self.assertEqual(len(one.branches), 1, "the folded condition has no outcomes")
        self.assertTrue(below_goal(self.files))

    def test_programs_and_instantiations_are_joined_by_line(self):
        for counts in ((0, 5), (3, 0)):
            add_export(export(*counts), "/r/core/graze/", self.files)
        one = self.files["sign.hpp"]
        self.assertEqual((one.missed_lines(), one.missed_branches()), ([], []))
        self.assertFalse(below_goal(self.files))
        self.assertIn("| sign.hpp | 6 of 6 | 100.0 | 2 of 2 | 100.0 |", table(self.files))

    def test_files_elsewhere_do_not_count(self):
        add_export(export(0, 5, "/usr/include/sign.hpp"), "/r/core/graze/", self.files)
        self.assertEqual(self.files, {})

    def test_the_page_gives_the_reason_or_asks_for_a_test(self):
        add_export(export(0, 5), "/r/core/graze/", self.files)
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            (root / "sign.hpp").write_text(SOURCE)
            (root / "reasons.txt").write_text("sign.hpp\n  return -1; | No negative number comes here.\n  gone() | Stale.\n")
            reasons = read_reasons(root / "reasons.txt")
            text = page(self.files, reasons, root, ["a_test"])
            self.assertIn("`return -1;`. **No negative number comes here.**", text)
            self.assertEqual([entry.used for entry in reasons["sign.hpp"]], [True, False])
            self.assertIn("a test is missing", page(self.files, {}, root, ["a_test"]))
            (root / "reasons.txt").write_text("  return -1; without a reason\n")
            with self.assertRaisesRegex(SystemExit, "reasons.txt:1: want `code . reason`"):
                read_reasons(root / "reasons.txt")


if __name__ == "__main__":
    unittest.main()
