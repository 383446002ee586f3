"""The paper's path-composition figure: a bar for each robot over time, coloured by how many robots
each stretch was planned together with, and hatched by the solver that planned it."""
from matplotlib.patches import Patch

from evaluation import svg
from evaluation.svg import plt

GROUPS = ((1, "alone", "#dcdcdc"), (2, "2 robots", "#56B4E9"), (4, "3 or 4", "#F0E442"),
          (8, "5 to 8", "#E69F00"), (10 ** 9, "9 and more", "#D55E00"))
HATCHES = {"decoupled-prm": "////", "composite-prm": "xxxx", "composite-rrt-connect": "....",
           "lockstep-query": "----", "cbs-mp": "\\\\\\\\"}  # all others: none
NAMED = 40  # robots up to which each has its name beside it


def level(count):
    return next(i for i, (most, _, _) in enumerate(GROUPS) if count <= most)


def draw(plan, name):
    """A plan's timeline as SVG; None where the plan is not solved, since it has no paths."""
    if plan["status"] != "solved":
        return None
    robots = plan["robots"]
    row = 0.24 if len(robots) <= NAMED else max(0.03, 9 / len(robots))
    figure, axes = plt.subplots(figsize=(11, 1.3 + row * len(robots)), constrained_layout=True)
    used = set()
    for y, robot in enumerate(robots):
        for segment in robot["segments"]:
            _bar(axes, y, segment, len(robots) <= NAMED)
            used.add((level(len(segment["robots"])),
                      segment["solver"] if len(robots) <= NAMED else ""))
    axes.set_ylim(len(robots) - 0.4, -0.6)
    axes.set_xlim(0, plan["makespan"])
    axes.set_xlabel("time (s)")
    axes.grid(axis="y", visible=False)
    if len(robots) <= NAMED:
        axes.set_yticks(range(len(robots)), [robot["name"] for robot in robots])
    else:
        axes.set_ylabel("robots")
    step = plan["timestep"]
    above = axes.secondary_xaxis("top", functions=(lambda t: t / step, lambda t: t * step))
    above.set_xlabel("timesteps")
    _legend(figure, used)
    return svg.text_of(figure, name, f"{plan['scene']}: for each of {len(robots)} robots a bar "
                       "over time, coloured by the number of robots planned together")


def _bar(axes, y, segment, edged):
    """edged: there is room to draw the bar's edges, and hatches."""
    look = {"height": 0.78, "edgecolor": "#333333", "linewidth": 0.5,
            "hatch": HATCHES.get(segment["solver"])} if edged else {"height": 1, "linewidth": 0}
    axes.barh(y, segment["to"] - segment["from"], left=segment["from"],
              color=GROUPS[level(len(segment["robots"]))][2], **look)


def _legend(figure, used):
    handles = [Patch(facecolor=color, edgecolor="#333333", linewidth=0.5, label=label)
               for i, (_, label, color) in enumerate(GROUPS) if any(i == one for one, _ in used)]
    handles += [Patch(facecolor="white", edgecolor="#333333", linewidth=0.5, label=solver,
                      hatch=HATCHES[solver])
                for solver in sorted({solver for _, solver in used} & set(HATCHES))]
    svg.legend_below(figure, handles, 9)
