"""Two failures of one mechanism are one finding, and of two mechanisms two."""

import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "fuzz" / "campaign"))
from mechanism import finding_id, mechanism  # noqa: E402

LAW = """target: tiers
law: times_meet
method: mpr/double
fault: late by 0x1.8p-3 at t = 0.25, normal (0x1p+0, -0x1.8p-2, nan)
case: {}
"""
ADDRESS = """==1==ERROR: AddressSanitizer: heap-buffer-overflow on address 0x602000000018 at pc 0x5
READ of size 8 at 0x602000000018 thread T0
    #0 0x55d0 in std::vector<double>::operator[](unsigned long) /usr/include/c++/12/bits/stl_vector.h:1125:9
    #1 0x55d1 in double graze::compiled::climb<double>(graze::compiled::Hull<double> const&) /home/x/graze/core/graze/support/climb.hpp:91:7
    #2 0x55d2 in main /home/x/graze/fuzz/target_main.cpp:3
"""


class Mechanism(unittest.TestCase):
    def test_numbers_do_not_tell_faults_apart(self):
        other = LAW.replace("0x1.8p-3", "0x1.99999999999ap-30").replace("0.25", "1e-300")
        self.assertEqual(mechanism(LAW, -6), mechanism(other, -6))
        self.assertEqual(mechanism(LAW, -6), "times_meet: mpr/double: late by # at t = #, normal (#, #, #)")

    def test_law_and_method_do(self):
        self.assertNotEqual(mechanism(LAW, -6), mechanism(LAW.replace("mpr/", "ca/"), -6))
        self.assertNotEqual(mechanism(LAW, -6), mechanism(LAW.replace("times_meet", "brackets_meet"), -6))

    def test_a_fault_that_nobody_is_blamed_for(self):
        self.assertEqual(mechanism("law: reads_back\nmethod: \nfault: another text\n", -6), "reads_back: another text")

    def test_a_sanitizer_is_told_by_the_first_function_of_ours(self):
        self.assertEqual(mechanism(ADDRESS, 1),
                         "AddressSanitizer: heap-buffer-overflow, graze::climb core/graze/support/climb.hpp")

    def test_and_without_debug_symbols_by_its_name_alone(self):
        bare = "==1==ERROR: libFuzzer: timeout after 61 seconds\n    #3 0x55 in graze::leave_line(int) (/b/fuzz_x+0x1)\n"
        self.assertEqual(mechanism(bare, 70), "libFuzzer: timeout, graze::leave_line")

    def test_undefined_behaviour_is_told_by_its_place(self):
        text = "/home/x/graze/core/graze/detail/shapes/scan.hpp:12:9: runtime error: 1e+300 is outside the range of type 'int'\n"
        self.assertEqual(mechanism(text, 1),
                         "undefined behaviour: # is outside the range of type 'int', core/graze/detail/shapes/scan.hpp:12")

    def test_no_report_at_all(self):
        self.assertEqual(mechanism("", -11), "ended by signal 11")
        self.assertEqual(mechanism("", 3), "ended with exit code 3")

    def test_ids_are_stable_and_differ_by_target(self):
        self.assertEqual(finding_id("tiers", "late"), finding_id("tiers", "late"))
        self.assertNotEqual(finding_id("tiers", "late"), finding_id("plans", "late"))


if __name__ == "__main__":
    unittest.main()
