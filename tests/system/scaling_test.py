"""tests/bench/scaling: a short measurement and a short simulation."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(os.environ["ACCORD"]).parents[1]


def scaling(*arguments):
    return subprocess.run([ROOT / "tests/bench/scaling", "--build", BUILD, *map(str, arguments)],
                          capture_output=True, text=True, timeout=200, check=False)


class Scaling(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.numbers = pathlib.Path(folder.name, "numbers.json")
        self.folder = pathlib.Path(folder.name)

    def test_measures_in_process_and_over_dds(self):
        result = scaling("--workers", "1,2", "--runs", 1, "--transports", "udp", "--json",
                         self.numbers, ROOT / "scenes/peer-planar-cross-008.yaml")
        self.assertEqual(0, result.returncode, result.stderr)
        self.assertEqual(2, result.stdout.count("| peer-planar-cross-008 |"), result.stdout)
        numbers = json.loads(self.numbers.read_text())[0]
        for entry in numbers["over_dds"]:
            for run in entry["runs"]:
                self.assertGreater(run["tasks"], 8)
                self.assertGreater(run["bytes"], 1000)
                self.assertGreater(run["first_task"], 0)
                # Attempts ahead of need that were dropped end after the run, and are counted.
                self.assertGreater(run["busy"], 0)

    def test_simulates_more_workers_than_there_are(self):
        made = subprocess.run([ROOT / "scenes/generate", "arm-cells", "32", "-o", self.folder],
                              capture_output=True, text=True, check=True).stdout.splitlines()[0]
        result = scaling("--simulate", "--workers", "1,8", "--json", self.numbers, made)
        self.assertEqual(0, result.returncode, result.stderr)
        one, eight = json.loads(self.numbers.read_text())[0]["rows"]
        self.assertGreater(one["seconds"] / eight["seconds"], 5)
        self.assertGreater(one["busy"], 0.9 * one["seconds"])

    def test_says_in_one_line_what_is_not_there(self):
        result = scaling("no-such-scene.yaml")
        self.assertEqual(2, result.returncode)
        self.assertIn("no scene no-such-scene.yaml", result.stderr)


if __name__ == "__main__":
    unittest.main()
