"""tests/bench/instructions on one small scene: what it lets pass, and what it says."""
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
ACCORD = os.environ["ACCORD"]
SCENE = "peer-inlet"


def instructions(record, *arguments):
    return subprocess.run([ROOT / "tests/bench/instructions", "--accord", ACCORD, "--file", record,
                           *arguments], capture_output=True, text=True, timeout=120, check=False)


class Instructions(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.file = pathlib.Path(folder.name, "record.txt")
        cls.file.write_text(f"{SCENE} 1 0\n")
        recorded = instructions(cls.file, "--record")
        assert recorded.returncode == 0, recorded.stderr
        cls.text = cls.file.read_text()
        cls.count = int(re.search(rf"^{SCENE} 1 (\d+)$", cls.text, re.MULTILINE)[1])

    def compare(self, factor, compiler=None):
        """With a record that is so many times what the scene takes."""
        text = self.text.replace(str(self.count), str(round(factor * self.count)))
        if compiler:
            text = re.sub(r"^compiler .*", f"compiler {compiler}", text, flags=re.MULTILINE)
        self.file.write_text(text)
        return instructions(self.file)

    def refused(self, text):
        self.file.write_text(text)
        result = instructions(self.file)
        self.assertEqual(2, result.returncode, result.stdout)
        return result.stderr

    def test_repeats_a_count_to_a_thousandth(self):
        result = self.compare(1)
        self.assertEqual(0, result.returncode, result.stdout + result.stderr)
        again = int(re.search(r"([\d,]+) instructions", result.stdout)[1].replace(",", ""))
        self.assertLess(abs(again - self.count), self.count / 1000)
        self.assertEqual(1, len(result.stdout.splitlines()), "nothing to add: " + result.stdout)

    def test_fails_where_a_run_costs_more_and_says_which_and_by_how_much(self):
        result = self.compare(0.88)
        self.assertEqual(1, result.returncode, result.stderr)
        self.assertRegex(result.stdout, rf"FAILED: {SCENE}, seed 1: .* \+1[34]\.\d% from")

    def test_passes_where_a_run_costs_less_and_asks_for_a_record(self):
        result = self.compare(1.15)
        self.assertEqual(0, result.returncode, result.stdout + result.stderr)
        self.assertRegex(result.stdout, rf"record this: {SCENE}, seed 1: .* -1[23]\.\d% from")
        self.assertIn("tests/bench/instructions --record", result.stdout)

    def test_says_that_it_does_not_compare_compilers(self):
        result = self.compare(0.5, compiler="GCC: (Elsewhere) 99.1")
        self.assertEqual(0, result.returncode, result.stdout + result.stderr)
        self.assertRegex(result.stdout, r"(?m)^NOT CHECKED: .*\(GCC: \(Elsewhere\) 99\.1\)")
        self.assertIn(f"{SCENE}, seed 1: ", result.stdout)

    def test_refuses_a_record_that_is_not_one(self):
        self.assertIn("record.txt:2: expected SCENE SEED COUNT, not 'peer-inlet 1'",
                      self.refused("compiler x\npeer-inlet 1\n"))
        self.assertIn("record.txt:1: expected", self.refused("peer-inlet 1 many\n"))
        self.assertIn("there are no runs", self.refused("# nothing\n"))
        self.assertIn("no-such-scene, seed 1: not measured", self.refused("no-such-scene 1 5\n"))
        self.file.unlink()
        result = instructions(self.file)
        self.assertEqual(2, result.returncode)
        self.assertIn("there is no record", result.stderr)


if __name__ == "__main__":
    unittest.main()
