"""The runs of one method on one scene, and what they say together."""
import collections
import dataclasses
import math
import statistics

from evaluation import rows


def percentile(values, share):
    """The least value that at least this share of them do not exceed (nearest rank)."""
    ordered = sorted(values)
    return ordered[max(0, math.ceil(share * len(ordered)) - 1)]


def spread(values):
    """Mean and standard deviation; None where there are no values."""
    if not values:
        return None
    return statistics.mean(values), statistics.stdev(values) if len(values) > 1 else 0.0


@dataclasses.dataclass(frozen=True)
class Group:
    scene: str
    method: str
    runs: list

    @property
    def family(self):
        return rows.family(self.scene)

    @property
    def robots(self):
        return max((int(run["robots"]) for run in self.runs if run["robots"]), default=None)

    @property
    def solved(self):
        return [run for run in self.runs if run["status"] == "solved"]

    @property
    def success(self):
        return len(self.solved) / len(self.runs)

    @property
    def failures(self):
        """For people: how often it ended in which other way, such as 'timeout 2'."""
        endings = collections.Counter(run["status"] for run in self.runs)
        return ", ".join(f"{status} {count}" for status, count in sorted(endings.items())
                         if status != "solved")

    @property
    def time_limit(self):
        return max(rows.number(run, "time_limit") for run in self.runs)

    def values(self, column):
        """The numbers of a column, of the runs that found a plan."""
        found = (rows.number(run, column) for run in self.solved)
        return [value for value in found if value is not None]

    @property
    def times(self):
        return self.values("planning_time")

    @property
    def ratios(self):
        """Sum of costs over its lower bound."""
        return [rows.number(run, "sum_of_costs") / rows.number(run, "lower_bound")
                for run in self.solved if rows.number(run, "lower_bound")]

    def time_at(self, share):
        """The planning time that this share of all runs needs at most; a failure needs for ever."""
        return percentile(self.times + [math.inf] * (len(self.runs) - len(self.solved)), share)

    def solvers(self):
        """How many subproblems each level solved, over all runs that found a plan."""
        counts = collections.Counter()
        for run in self.solved:
            for part in run["solved_by"].split():
                name, count = part.rsplit(":", 1)
                counts[name] += int(count)
        return ", ".join(f"{name} {count}" for name, count in sorted(counts.items()))


def groups(runs):
    """By scene, then by method in their usual order."""
    found = {}
    for run in runs:
        found.setdefault((run["scene"], run["method"]), []).append(run)
    order = {method: i for i, method in enumerate(rows.METHODS)}
    return [Group(scene, method, found[scene, method])
            for scene, method in sorted(found, key=lambda name: (name[0], order.get(name[1], 99)))]


def by_family(all_groups):
    """Family: its groups, by number of robots."""
    families = {}
    for group in sorted(all_groups, key=lambda group: (group.family, group.robots or 0)):
        families.setdefault(group.family, []).append(group)
    return families
