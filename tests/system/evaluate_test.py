"""tests/bench/evaluate on two small scenes: what it writes, and that it goes on where it was."""
import csv
import os
import pathlib
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
ACCORD = os.environ["ACCORD"]


def evaluate(out, *arguments):
    return subprocess.run([ROOT / "tests/bench/evaluate", out, "--accord", ACCORD, *arguments],
                          capture_output=True, text=True, timeout=120, check=False)


class Evaluate(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.out = pathlib.Path(folder.name, "runs.csv")

    def rows(self):
        with self.out.open(newline="") as file:
            return list(csv.DictReader(file))

    def test_writes_a_row_a_run_and_repeats_none(self):
        scenes = [ROOT / "scenes/peer-inlet.yaml", ROOT / "scenes/peer-parallel-008.yaml"]
        result = evaluate(self.out, "--methods", "arc,decoupled-prm", "--seeds", "1",
                          "--timeout", "20", *scenes)
        self.assertEqual(0, result.returncode, result.stderr)
        rows = self.rows()
        self.assertEqual(4, len(rows))
        for row in rows:
            self.assertEqual("solved", row["status"])
            self.assertGreater(float(row["planning_time"]), 0)
            self.assertGreaterEqual(float(row["sum_of_costs"]), 0.999 * float(row["lower_bound"]))
            self.assertGreater(float(row["peak_memory"]), 1)
        self.assertIn("| peer-inlet | arc | 1/1 | 2 |", result.stdout)

        evaluate(self.out, "--methods", "arc", "--seeds", "2", *scenes)
        self.assertEqual(rows, self.rows()[:4])
        self.assertEqual(6, len(self.rows()))

    def test_counts_who_runs_out_of_time_and_of_memory(self):
        scene = ROOT / "scenes/fleet-1000.yaml"
        said = evaluate(self.out, "--seeds", "1", "--timeout", "0.05", scene).stderr
        said += evaluate(self.out, "--seeds", "2", "--memory", "90", scene).stderr
        self.assertEqual(["timeout", "memory"], [row["status"] for row in self.rows()], said)

    def test_knows_its_methods(self):
        result = evaluate(self.out, "--methods", "magic")
        self.assertEqual(2, result.returncode)
        self.assertIn("no method 'magic'; there are arc, decoupled-prm", result.stderr)


if __name__ == "__main__":
    unittest.main()
