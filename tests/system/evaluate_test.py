"""tests/bench/evaluate and tests/bench/report on small scenes: the short form of an evaluation."""
import csv
import html.parser
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
ACCORD = os.environ["ACCORD"]
INLET, PARALLEL = ROOT / "scenes/peer-inlet.yaml", ROOT / "scenes/peer-parallel-008.yaml"


def run(script, *arguments):
    return subprocess.run([ROOT / "tests/bench" / script, *map(str, arguments), "--accord", ACCORD],
                          capture_output=True, text=True, timeout=240, check=False)


class Page(html.parser.HTMLParser):
    """What the tests look at in a report. Throws where elements are not closed in order."""

    VOID = ("meta", "br", "link")

    def __init__(self, text):
        super().__init__()
        self.ids, self.pictures, self.links, self._open = [], 0, [], []
        self.rows = []  # of tables: lists of texts
        self.feed(text)
        assert not self._open, self._open

    def handle_starttag(self, tag, attrs):
        values = dict(attrs)
        self.ids += [values["id"]] if "id" in values else []
        self.links += [values[name] for name in ("href", "src", "xlink:href") if name in values]
        self.pictures += tag == "svg" and "aria-label" in values
        if tag == "tr":
            self.rows.append([])
        if tag in ("td", "th"):
            self.rows[-1].append("")
        if tag not in self.VOID:
            self._open.append(tag)

    def handle_startendtag(self, tag, attrs):
        self.handle_starttag(tag, attrs)
        if tag not in self.VOID:
            self._open.pop()

    def handle_endtag(self, tag):
        assert self._open.pop() == tag, (tag, self.getpos())

    def handle_data(self, data):
        if self._open and self._open[-1] in ("td", "th"):
            self.rows[-1][-1] += data

    def row(self, *start):
        """The first row of a table that starts so."""
        return next(row for row in self.rows if row[:len(start)] == list(start))


class EvaluationTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.out = self.folder / "runs.csv"

    def rows(self):
        with self.out.open(newline="") as file:
            return list(csv.DictReader(file))


class Evaluate(EvaluationTest):
    def test_writes_a_row_a_run_and_repeats_none(self):
        result = run("evaluate", self.out, "--methods", "arc,decoupled-prm", "--seeds", 1,
                     "--timeout", 20, INLET, PARALLEL)
        self.assertEqual(0, result.returncode, result.stderr)
        self.assertIn("4/4: peer-parallel-008, decoupled-prm, seed 1", result.stderr)
        rows = self.rows()
        self.assertEqual(4, len(rows))
        for row in rows:
            self.assertEqual("solved", row["status"])
            self.assertGreater(float(row["planning_time"]), 0)
            self.assertGreater(float(row["time_to_first_plan"]), float(row["planning_time"]))
            self.assertGreaterEqual(float(row["sum_of_costs"]), 0.999 * float(row["lower_bound"]))
            self.assertGreaterEqual(float(row["makespan"]), 0.999 * float(row["bound_makespan"]))
            self.assertGreaterEqual(int(row["largest_group"]), 1)
            self.assertGreater(float(row["peak_memory"]), 1)
        self.assertIn("| peer-inlet | arc | 1/1 | 2 |", result.stdout)

        # Killed while it wrote a row: what is there of it is not a run.
        with self.out.open("a") as file:
            file.write("peer-inlet,2,arc,2,sol")
        run("evaluate", self.out, "--methods", "arc", "--seeds", 2, INLET, PARALLEL)
        self.assertEqual(rows, self.rows()[:4])
        self.assertEqual([("peer-inlet", "2"), ("peer-parallel-008", "2")],
                         [(row["scene"], row["seed"]) for row in self.rows()[4:]])
        self.assertEqual({"solved"}, {row["status"] for row in self.rows()})
        sessions = json.loads((self.folder / "runs.about.json").read_text())
        self.assertEqual(2, len(sessions))
        self.assertIn("--seeds 2", sessions[1]["command"])

    def test_counts_who_runs_out_of_time_and_of_memory(self):
        scene = ROOT / "scenes/fleet-1000.yaml"
        said = run("evaluate", self.out, "--seeds", 1, "--timeout", 0.05, scene).stderr
        said += run("evaluate", self.out, "--seeds", 2, "--memory", 90, scene).stderr
        self.assertEqual(["timeout", "memory"], [row["status"] for row in self.rows()], said)
        for row in self.rows():
            self.assertEqual("1000", row["robots"])
            self.assertEqual("", row["time_to_first_plan"])

    def test_knows_its_methods_scenes_and_program(self):
        for wrong, why in ((["--methods", "magic"], "no method 'magic'; there are arc, decoupled-"),
                           ([self.folder / "lost.yaml"], "no scene"),
                           ([INLET, "--accord", self.folder / "lost"], "no program")):
            command = [ROOT / "tests/bench/evaluate", self.out, "--accord", ACCORD, *wrong]
            result = subprocess.run(command, capture_output=True, text=True, timeout=60,
                                    check=False)
            self.assertEqual(2, result.returncode)
            self.assertIn(why, result.stderr)
        self.assertFalse(self.out.exists())

    def test_refuses_a_file_of_another_version(self):
        self.out.write_text("scene,method,seed,duration\npeer-inlet,arc,1,0.2\n")
        before = self.out.read_bytes()
        for script, more in (("evaluate", [INLET]), ("report", ["-o", self.folder / "r.html"])):
            result = run(script, self.out, *more)
            self.assertEqual(1, result.returncode)
            self.assertIn("not those of this version; write to another file", result.stderr)
        self.assertEqual(before, self.out.read_bytes())


class Report(EvaluationTest):
    def evaluated(self):
        """Two scenes of one family and one of the paper's; one method that fails on the latter."""
        result = run("evaluate", self.out, "--methods", "arc,decoupled-prm", "--seeds", 2,
                     "--timeout", 1, "--plans", self.folder / "plans",
                     "--report", self.folder / "first.html", ROOT / "scenes/low-mobile-08.yaml",
                     ROOT / "scenes/low-mobile-16.yaml", ROOT / "scenes/high-mobile.yaml")
        self.assertEqual(0, result.returncode, result.stderr)
        return self.folder / "plans"

    def test_shows_figures_tables_targets_and_timelines_of_failures_too(self):
        plans = self.evaluated()
        timelines = [plans / "low-mobile-08.arc.json", plans / "high-mobile.decoupled-prm.json"]
        again = [run("report", self.out, "-o", self.folder / name, "--timeline", *timelines)
                 for name in ("second.html", "third.html")]
        self.assertEqual([0, 0], [result.returncode for result in again], again[0].stderr)
        text = (self.folder / "second.html").read_text()
        self.assertEqual(text, (self.folder / "third.html").read_text())
        page = Page(text)

        # Figures: two pictures of scenes, low-mobile against robots, two of boxes, a timeline.
        self.assertEqual(6, page.pictures)
        self.assertEqual(len(page.ids), len(set(page.ids)))
        self.assertEqual([], [link for link in page.links if not link.startswith("#")])
        self.assertIn("high-mobile, decoupled-prm, seed 1: timeout; no paths to draw", text)
        self.assertIn("0/2 (timeout 2)", text)

        # Tables: a failure is a row as others are, and infinitely slow.
        failed = page.row("high-mobile", "2", "decoupled-prm", "0/2")
        self.assertIn("never", failed)
        self.assertIn("timeout 2", failed)
        self.assertEqual("2/2", page.row("low-mobile-16", "16", "arc")[3])

        # Beside the paper.
        self.assertEqual(["24.5 s ± 20.5 s", "450.1 ± 19.6", "100 %", "not run"],
                         page.row("adaptive-mobile", "16", "arc")[3:7])
        ours = page.row("high-mobile", "2", "arc")
        self.assertEqual(("100 %", "100 %", "2"), (ours[5], ours[8], ours[9]))

        # Targets.
        self.assertEqual("not known", page.row("peer-parallel-256: planning time, p50")[3])
        self.assertIn(page.row("high-mobile: planning time, p50")[3], ("reached", "missed"))
        self.assertEqual("reached", page.row("every run: peak memory")[3])

        self.assertIn("--seeds 2", page.row("command")[1])

    def test_says_what_it_cannot_read(self):
        result = run("report", self.out, "-o", self.folder / "report.html")
        self.assertEqual(1, result.returncode)
        self.assertIn("runs.csv: there are no runs in it", result.stderr)


if __name__ == "__main__":
    unittest.main()
