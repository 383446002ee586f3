"""The speed that Accord has to reach, and whether an evaluation's runs of ARC reached it."""
import dataclasses
import math

from evaluation import rows

TIMES = (  # scene, share of the runs, limit of the planning time (s)
    ("adaptive-mobile", 0.5, 0.010), ("adaptive-mobile", 0.99, 0.100),
    ("adaptive-manipulator", 0.5, 0.020), ("adaptive-manipulator", 0.99, 0.200),
    ("low-mobile-32", 0.5, 0.005),
    ("high-mobile", 0.5, 0.010),
    ("high-manipulator-4", 0.5, 0.050),
    ("low-manipulator-16", 0.5, 0.200),
    ("peer-parallel-256", 0.5, 0.010),
    ("peer-circle-064", 0.5, 0.100),
    ("random-crossing-1000", 0.5, 1.0),
    ("fleet-1000", 0.5, 1.0),
    ("peer-planar-cross-128", 0.5, 0.200),
)
CIRCLE_STRETCH = 1.2  # makespan over bound, peer-circle-064
GROWTH, GROWTH_FROM, GROWTH_TO = 1.3, 50, 2000  # exponent of fleet's times between these sizes
PROOF_SHARE = 0.2  # of a plan's planning time
MEMORY = 500  # MB


@dataclasses.dataclass(frozen=True)
class Outcome:
    what: str
    limit: str
    got: str
    reached: bool  # None: the runs do not say


def seconds(value):
    """A time as people say it."""
    if math.isinf(value):
        return "never"
    return f"{1000 * value:.3g} ms" if value < 1 else f"{value:.3g} s"


def outcomes(groups):
    """All targets, in order."""
    arc = {group.scene: group for group in groups if group.method == "arc"}
    return [*(_time(arc, *target) for target in TIMES), _circle(arc), _growth(arc), _proof(arc),
            _memory(arc)]


def _time(arc, scene, share, limit):
    what = f"{scene}: planning time, p{100 * share:g}"
    group = arc.get(scene)
    if group is None:
        return Outcome(what, seconds(limit), "not run", None)
    got = group.time_at(share)
    return Outcome(what, seconds(limit),
                   f"{seconds(got)} ({len(group.solved)} of {len(group.runs)} runs solved)",
                   got <= limit)


def _circle(arc):
    what, limit = "peer-circle-064: makespan over bound, largest", f"{CIRCLE_STRETCH:g}"
    group = arc.get("peer-circle-064")
    if group is None:
        return Outcome(what, limit, "not run", None)
    stretches = [rows.number(run, "makespan") / rows.number(run, "bound_makespan")
                 for run in group.solved if rows.number(run, "bound_makespan")]
    if not stretches:
        return Outcome(what, limit, "no plan", False)
    return Outcome(what, limit, f"{max(stretches):.3f}", max(stretches) <= CIRCLE_STRETCH)


def exponent(sizes, times):
    """Of the power of the size that fits the times best (least squares of logarithms)."""
    xs, ys = [math.log(size) for size in sizes], [math.log(time) for time in times]
    x, y = sum(xs) / len(xs), sum(ys) / len(ys)
    return (sum((a - x) * (b - y) for a, b in zip(xs, ys)) / sum((a - x) ** 2 for a in xs))


def _growth(arc):
    what = f"fleet: time grows with n, from {GROWTH_FROM} to {GROWTH_TO}"
    limit = f"n^{GROWTH:g}"
    points = sorted((group.robots, group.time_at(0.5)) for group in arc.values()
                    if group.family == "fleet" and group.robots
                    and GROWTH_FROM <= group.robots <= GROWTH_TO)
    if len(points) < 2:
        return Outcome(what, limit, "not run", None)
    sizes, times = zip(*points)
    if math.inf in times:
        return Outcome(what, limit, "no plan at one of the sizes", False)
    got = exponent(sizes, times)
    whole = (sizes[0], sizes[-1]) == (GROWTH_FROM, GROWTH_TO)
    text = f"n^{got:.2f}, fitted to the medians of {', '.join(map(str, sizes))}"
    return Outcome(what, limit, text if whole else f"{text} only",
                   got <= GROWTH if whole or got > GROWTH else None)


def _largest(arc, value, only_solved):
    """The run with the largest value, as (value, 'scene, seed'); None where no run has one."""
    found = [(value(run), f"{run['scene']}, seed {run['seed']}") for group in arc.values()
             for run in (group.solved if only_solved else group.runs) if value(run) is not None]
    return max(found, default=None)


def _proof(arc):
    what, limit = "every plan: share of its planning time that verification takes", "20 %"

    def share(run):
        proof, whole = rows.number(run, "proof_time"), rows.number(run, "planning_time")
        return proof / whole if proof is not None and whole else None

    worst = _largest(arc, share, only_solved=True)
    if worst is None:
        return Outcome(what, limit, "not run", None)
    shares = [share(run) for group in arc.values() for run in group.solved
              if share(run) is not None]
    above = sum(value > PROOF_SHARE for value in shares)
    return Outcome(what, limit, f"{100 * worst[0]:.0f} % at worst ({worst[1]}); above 20 % in "
                   f"{above} of {len(shares)} plans", worst[0] <= PROOF_SHARE)


def _memory(arc):
    what, limit = "every run: peak memory", f"under {MEMORY} MB"
    worst = _largest(arc, lambda run: rows.number(run, "peak_memory"), only_solved=False)
    if worst is None:
        return Outcome(what, limit, "not run", None)
    return Outcome(what, limit, f"{worst[0]:.0f} MB at worst ({worst[1]})", worst[0] < MEMORY)
