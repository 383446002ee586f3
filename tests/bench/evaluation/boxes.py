"""Box plots of a family: the spread of time and of cost, a row for each scene and method."""
from evaluation import paper, style, svg
from evaluation.svg import plt

ROW = 0.27  # inches
BETWEEN_SCENES = 0.6  # rows


def draw(family, groups):
    """Two panels as SVG. Runs without a plan are a cross at their limit and a text on the right."""
    places = _places(groups)
    figure, panels = plt.subplots(1, 2, figsize=(11, 1.1 + ROW * places[-1]), sharey=True,
                                  constrained_layout=True)
    panels[0].set_xscale("log")
    for place, group in zip(places, groups):
        _box(panels[0], place, group.times, style.color(group.method))
        _box(panels[1], place, group.ratios, style.color(group.method))
        _ending(panels, place, group)
    failed = any(group.failures for group in groups)
    panels[0].set_xlabel("planning time (s)" + ("; cross: no plan, at the limit" if failed else ""))
    panels[0].set_xlim(style.seconds_axis(panels[0].xaxis, panels[0].get_xlim()))
    panels[1].set(xlabel="sum of costs / lower bound", xlim=style.cost_limits(groups))
    one_scene = len({group.scene for group in groups}) == 1
    panels[0].set_yticks(places, [group.method if one_scene else f"{group.scene}, {group.method}"
                                  for group in groups])
    panels[0].set_ylim(places[-1] + 0.7, -0.7)
    for panel in panels:
        panel.grid(axis="y", visible=False)
    return svg.text_of(figure, f"{family}-boxes", f"{family}: box plots of planning time and of "
                       "cost over its lower bound, a row for each scene and method")


def _places(groups):
    """The height of each row: scenes are a little apart."""
    places = [0.0]
    for before, group in zip(groups, groups[1:]):
        places.append(places[-1] + 1 + BETWEEN_SCENES * (group.scene != before.scene))
    return places


def _box(panel, place, values, color):
    if values:
        panel.boxplot([values], positions=[place], widths=0.62, vert=False, patch_artist=True,
                      manage_ticks=False, whis=(0, 100),
                      boxprops={"facecolor": color + "55", "edgecolor": color},
                      medianprops={"color": color, "linewidth": 2},
                      whiskerprops={"color": color}, capprops={"color": color})


def _ending(panels, place, group):
    text = f"{len(group.solved)}/{len(group.runs)}"
    if group.failures:
        text += f" ({group.failures})"
        panels[0].plot(group.time_limit, place, color=style.color(group.method), **style.CROSS)
    panels[1].text(1.01, place, text, transform=panels[1].get_yaxis_transform(), va="center",
                   fontsize=8)
    said = paper.of(group)
    if said and said.time:
        panels[0].plot(said.time[0], place, color=style.color(group.method), **style.STAR)
        panels[0].annotate("paper's mean", (said.time[0], place), (-8, 0), ha="right",
                           textcoords="offset points", va="center", fontsize=8)
