"""One run: a scene planned by a method with a seed, in a process of its own, and proved."""
import dataclasses
import json
import pathlib
import re
import shutil
import subprocess
import sys

MEASURED = pathlib.Path(__file__).with_name("measured.py")
STATUS_OF_EXIT = {0: "solved", 4: "infeasible", 5: "timeout"}  # all others: error
GRACE = 60  # s after its time limit at which a run is taken to hang
COUNTS = {  # column: the plan's statistic
    "conflicts": "conflicts_found", "rounds": "rounds", "subproblems": "subproblems",
    "windows_grown": "windows_grown", "robots_taken_in": "robots_taken_in",
    "motion_checks": "motion_checks", "distance_queries": "distance_queries",
    "expansions": "expansions", "lower_bound": "lower_bound", "proof_time": "proof_time"}


@dataclasses.dataclass(frozen=True)
class Limits:
    timeout: float  # s
    memory: int  # MB of address space
    workers: int


class Runner:
    """Runs `accord`.

    folder: for its plans, which are overwritten. keep: a folder in which the plan of each scene and
    method with the first seed stays, or None.
    """

    def __init__(self, accord, limits, folder, keep=None):
        self._accord, self._limits, self._keep = str(accord), limits, keep
        self._plan_file = pathlib.Path(folder, "plan.json")
        self._scenes = {}  # path: its facts

    def run(self, scene, method, seed):
        """A row (see rows.COLUMNS), and a sentence where accord did something wrong, or None."""
        self._plan_file.unlink(missing_ok=True)
        measured = self._plan(scene, method, seed)
        row = {"scene": scene.stem, "method": method, "seed": seed, "workers": self._limits.workers,
               "time_limit": self._limits.timeout, "peak_memory": round(measured["peak"], 1),
               **self._scene_facts(scene)}
        row["status"], trouble = outcome(measured)
        if self._plan_file.exists():
            row.update(plan_facts(json.loads(self._plan_file.read_text())))
        if row["status"] == "solved":
            row["time_to_first_plan"] = round(measured["wall"], 6)
            trouble = self._refutation(scene)
            if trouble:
                row["status"] = "refuted"
        if self._keep and seed == 1 and self._plan_file.exists():
            shutil.copy(self._plan_file, self._keep / f"{scene.stem}.{method}.json")
        return row, trouble and f"{scene.stem}, {method}, seed {seed}: {trouble}"

    def _plan(self, scene, method, seed):
        limits = self._limits
        command = [self._accord, "plan", scene, "-o", self._plan_file, "--seed", seed,
                   "--method", method, "--timeout", limits.timeout, "--workers", limits.workers,
                   "--quiet"]
        child = [sys.executable, MEASURED, limits.memory, limits.timeout + GRACE, *command]
        result = subprocess.run(list(map(str, child)), capture_output=True, text=True, check=True)
        return json.loads(result.stdout)

    def _refutation(self, scene):
        """Why the plan is wrong, or None: it is proved."""
        command = [self._accord, "verify", "--quiet", str(scene), str(self._plan_file)]
        proof = subprocess.run(command, capture_output=True, text=True, check=False)
        if proof.returncode == 0:
            return None
        return (proof.stdout + proof.stderr).strip() or f"verify: exit {proof.returncode}"

    def _scene_facts(self, scene):
        """Robots, and the least makespan that can be (s): the longest of the straight ways."""
        if scene not in self._scenes:
            info = subprocess.run([self._accord, "info", str(scene)], capture_output=True,
                                  text=True, check=False).stdout
            robots = re.search(r"^robots +(\d+)", info, re.MULTILINE)
            bound = re.search(r"^at least +makespan ([\d.]+) s", info, re.MULTILINE)
            self._scenes[scene] = {"robots": robots.group(1) if robots else "",
                                   "bound_makespan": bound.group(1) if bound else ""}
        return self._scenes[scene]


def outcome(measured):
    """The status of a run, and what is wrong with accord or None."""
    if measured["hung"]:
        return "error", f"killed {GRACE} s after its time limit"
    if measured["code"] != 0 and "memory" in measured["err"]:
        return "memory", None
    status = STATUS_OF_EXIT.get(measured["code"], "error")
    if status == "error":
        return status, f"exit {measured['code']}: {measured['err']}"
    return status, None


def plan_facts(plan):
    """The columns that a plan tells."""
    counts = plan["statistics"]
    facts = {column: counts.get(name, "") for column, name in COUNTS.items()}
    facts["planning_time"] = plan["planning_time"]
    facts["solved_by"] = " ".join(f"{name.removeprefix('solved_by_')}:{int(count)}"
                                  for name, count in counts.items()
                                  if name.startswith("solved_by_"))
    if plan["status"] == "solved":
        for name in ("sum_of_costs", "sum_of_costs_timesteps", "makespan"):
            facts[name] = plan[name]
        facts["largest_group"] = max(len(segment["robots"]) for robot in plan["robots"]
                                     for segment in robot["segments"])
    return facts
