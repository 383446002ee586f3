"""An evaluation as one HTML file that needs nothing else: where it comes from, the targets, the
paper's numbers beside ours, each family's figures and table, and timelines of plans."""
import json
import pathlib
import statistics
import subprocess
import tempfile

from evaluation import (against_robots, boxes, page, paper, rows, sessions, summary, svg, targets,
                        timeline)
from evaluation.page import name, number
from evaluation.targets import seconds

READING = (
    "Every run is a process of its own; a run counts as solved when accord verify, which trusts "
    "no planner, has proved its plan free of collisions at every instant. Planning time is the "
    "plan's own, from the request to the proved plan; time to the first plan is the process's, "
    "with reading the scene and writing the plan. The lower bound of costs is their sum if "
    "nobody had to give way. Medians and means are over solved runs; p50 and p99 are over all "
    "runs, and a run without a plan counts as infinitely slow. Of fewer than 100 runs, p99 is "
    "the slowest.")


def write(path, csv_paths, plan_paths=(), scenes_dir=None, accord=None):
    """Writes the report to path. Throws rows.Unusable.

    csv_paths: of evaluate; where several hold the same scene, method and seed, the last counts.
    plan_paths: plans whose timelines are drawn. scenes_dir: where the scenes are, which are drawn
    by accord; no pictures without either.
    """
    runs = {rows.key(run): run for csv_path in csv_paths for run in _read(csv_path)}
    groups = summary.groups(runs.values())
    families = summary.by_family(groups)
    parts = [_origin(csv_paths, groups), _contents(families), _targets(groups), _paper(groups),
             *_timelines(plan_paths)]
    for family, members in families.items():
        parts += _family(family, members, scenes_dir, accord)
    parts.append(_faults(groups))
    path.write_text(page.document("Accord: evaluation", parts), encoding="utf-8")


def _read(csv_path):
    found = rows.read(csv_path)
    if not found:
        raise rows.Unusable(f"{csv_path}: there are no runs in it")
    return found


def _origin(csv_paths, groups):
    known = [session for csv_path in csv_paths for session in sessions.read(csv_path)]
    lines = []
    for name in dict.fromkeys(name for session in known for name in session):
        for text in dict.fromkeys(session[name] for session in known if session.get(name)):
            lines.append([name, text])
    runs = [run for group in groups for run in group.runs]
    limits = sorted({float(run["time_limit"]) for run in runs})
    workers = sorted({int(run["workers"]) for run in runs})
    lines += [["runs", f"{len(runs)} of {len({group.scene for group in groups})} scenes by "
               f"{len({group.method for group in groups})} methods"],
              ["time limit", ", ".join(f"{limit:g} s" for limit in limits)],
              ["workers", ", ".join(map(str, workers))]]
    note = "" if known else page.paragraph("Nobody noted on what machine these runs were made.")
    return page.table("Where these numbers come from", ["", ""], lines) + note + \
        page.paragraph(READING)


def _contents(families):
    return page.links([("targets", "Targets"), ("paper", "Beside the paper"),
                       *((family, family) for family in families)])


def _targets(groups):
    words = {True: page.Cell("reached", "yes"), False: page.Cell("missed", "no"),
             None: page.Cell("not known")}
    lines = [[outcome.what, outcome.limit, outcome.got, words[outcome.reached]]
             for outcome in targets.outcomes(groups)]
    return page.heading("Targets", "targets") + page.table(
        "The speed that Accord has to reach, with ARC", ["what", "target", "got", ""], lines)


def _percent(share):
    return "" if share is None else f"{100 * share:.0f} %"


def _paper(groups):
    lines = []
    for said in paper.RESULTS:
        ours = [group for group in groups if paper.of(group) is said]
        for i, group in enumerate(ours or [None]):
            lines.append([name(said.family),
                          number(group.robots if group else said.robots or "all"),
                          name(said.method), *_paper_cells(said), *_our_cells(group),
                          said.says if i == 0 else ""])
    return page.heading("Beside the paper", "paper") + page.table(
        f"The paper's numbers ({paper.TRIALS} trials of at most {paper.TIME_LIMIT} s, on a machine "
        "that it does not name), as far as its text gives them, and ours. Mean ± standard "
        "deviation. The scenes are modelled on its figures, so times compare in their order of "
        "magnitude, and costs not at all.",
        ["scenario", "robots", "method", "paper: time", "paper: cost, timesteps", "paper: success",
         "ours: time", "ours: cost, timesteps", "ours: success", "runs", "the paper says"],
        lines) + page.paragraph("No number where the paper gives none: its plots are pictures.")


def _mean(spread, text):
    """spread: mean and standard deviation, or None."""
    return f"{text(spread[0])} ± {text(spread[1])}" if spread else ""


def _paper_cells(said):
    return [number(_mean(said.time, seconds)), number(_mean(said.cost, "{:.1f}".format)),
            number(_percent(said.success))]


def _our_cells(group):
    if group is None:
        return [number("not run"), number(""), number(""), number("")]
    costs = group.values("sum_of_costs_timesteps")
    return [number(_mean(summary.spread(group.times), seconds)),
            number(_mean(summary.spread(costs), "{:.1f}".format)),
            number(_percent(group.success)), number(len(group.runs))]


def _timelines(plan_paths):
    parts = []
    for i, plan_path in enumerate(plan_paths):
        plan = json.loads(pathlib.Path(plan_path).read_text())
        picture = timeline.draw(plan, f"timeline{i}")
        title = f"{plan['scene']}, {plan['method']}, seed {plan['seed']}"
        if picture is None:
            parts.append(page.paragraph(f"{title}: {plan['status']}; no paths to draw."))
        else:
            parts.append(page.figure(picture, title))
    if parts:
        parts.insert(0, page.heading("Who was planned together", "timelines") + page.paragraph(
            "The paper's path-composition figure: for each robot, in which composition of robots "
            "each stretch of its path was planned."))
    return parts


def _family(family, groups, scenes_dir, accord):
    yield page.heading(family, family)
    for scene in dict.fromkeys(group.scene for group in reversed(groups)):
        picture = _picture(scene, scenes_dir, accord)
        if picture:
            yield picture
            break
    if len({group.robots for group in groups if group.robots}) > 1:
        yield page.figure(against_robots.draw(family, groups),
                          "Median; the bar reaches from the least to the largest of the runs.")
    yield page.figure(boxes.draw(family, groups),
                      "Box: the middle half; line: median; whiskers: least and largest. On the "
                      "right: how many runs found a plan, and what the others ended with.")
    yield _family_table(family, groups)


def _family_table(family, groups):
    lines = []
    for group in groups:
        memory = max(rows.number(run, "peak_memory") for run in group.runs)
        lines.append([
            name(group.scene), number(group.robots or ""), name(group.method),
            number(f"{len(group.solved)}/{len(group.runs)}"),
            _median(group.times, seconds), number(seconds(group.time_at(0.99))),
            number(seconds(max(group.times)) if group.times else ""),
            _median(group.values("time_to_first_plan"), seconds),
            _median(group.ratios, "{:.2f}".format),
            _median(group.values("sum_of_costs_timesteps"), "{:.0f}".format),
            _median(group.values("makespan"), "{:.2f} s".format), number(f"{memory:.0f} MB"),
            group.solvers() or ("none needed" if group.solved else ""), group.failures])
    return page.table(f"{family}: median, p99 and largest planning time, and medians", [
        "scene", "robots", "method", "proved", "median", "p99", "largest", "to first plan",
        "cost / bound", "cost, timesteps", "makespan", "peak memory", "solved by", "failed"], lines)


def _median(values, text):
    return number(text(statistics.median(values)) if values else "")


def _picture(scene, scenes_dir, accord):
    """The scene as accord draws it, or nothing where that cannot be done."""
    path = scenes_dir and pathlib.Path(scenes_dir, f"{scene}.yaml")
    if not accord or not path or not path.exists():
        return ""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder, "scene.svg")
        try:
            drawn = subprocess.run([str(accord), "render", str(path), "-o", str(out)], timeout=60,
                                   capture_output=True, check=False).returncode == 0
        except (OSError, subprocess.TimeoutExpired):
            drawn = False
        if not drawn or out.stat().st_size > 300_000:  # thousands of robots: too large for a page
            return ""
        comment = path.read_text().split("\n", 1)[0].lstrip("# ")
        text = svg.for_page(out.read_text(), f"{scene}-scene", f"{scene}: {comment}")
        return page.figure(text, f"{scene}: {comment}", "picture")


def _faults(groups):
    """Runs that ended otherwise than by an answer."""
    lines = [[run["scene"], run["method"], run["seed"], run["status"]] for group in groups
             for run in group.runs if run["status"] in rows.FAULTS]
    head = page.heading("Faults", "faults")
    if not lines:
        return head + page.paragraph("No run was refuted or ended with an error.")
    return head + page.table("Runs that are bugs of Accord", ["scene", "method", "seed", "status"],
                             lines)
