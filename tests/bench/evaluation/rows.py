"""The CSV file of an evaluation: a row a run, each a dict of texts; an empty text: not known."""
import csv
import re

METHODS = ("arc", "decoupled-prm", "composite-prm", "composite-rrt-connect", "cbs-mp")
FAULTS = ("refuted", "error")  # statuses that are bugs of accord; other failures are answers
COLUMNS = (
    "scene", "robots", "method", "seed",
    "status",  # solved, infeasible, timeout, memory, refuted, or error
    "time_to_first_plan",  # s, wall clock from the start of the process until it ended with a plan
    "planning_time", "proof_time",  # s, as the plan says; the first includes the second
    "sum_of_costs", "sum_of_costs_timesteps",  # s, and the paper's unit
    "makespan",  # s
    "lower_bound",  # s: the sum of costs if nobody had to give way
    "bound_makespan",  # s: the longest of the straight ways
    "conflicts", "rounds", "subproblems",
    "solved_by",  # solver:count ..., the subproblems solved on each level
    "largest_group",  # robots planned together
    "windows_grown", "robots_taken_in", "motion_checks", "distance_queries", "expansions",
    "peak_memory",  # MB, resident
    "time_limit",  # s
    "workers")


class Unusable(Exception):
    """A file that does not hold rows of this version; the text says why."""


def key(row):
    return row["scene"], row["method"], str(row["seed"])


def number(row, column):
    """The number in a column, or None."""
    return float(row[column]) if row[column] else None


def family(scene):
    """A scene's name without its number of robots: scenes of a family differ in size only."""
    return re.sub(r"-\d+(?=-|$)", "", scene, count=1)


def read(path):
    """The rows of a file, none where there is no file. What an interruption left of a last line is
    cut off. Throws Unusable."""
    if not path.exists():
        return []
    text = path.read_text()
    if text and not text.endswith("\n"):
        text = text[:text.rfind("\n") + 1]
        path.write_text(text)
    reader = csv.DictReader(text.splitlines())
    if text and tuple(reader.fieldnames) != COLUMNS:
        raise Unusable(f"{path}: its columns are not those of this version; write to another file")
    return list(reader)


class Writer:
    """Adds rows to a file, each at once, so that an interruption loses at most one."""

    def __init__(self, path):
        self._file = path.open("a", newline="")
        self._writer = csv.DictWriter(self._file, COLUMNS, restval="", lineterminator="\n")
        if self._file.tell() == 0:
            self._writer.writeheader()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._file.close()

    def add(self, row):
        """The row as it would be read."""
        self._writer.writerow(row)
        self._file.flush()
        return {column: str(row.get(column, "")) for column in COLUMNS}
