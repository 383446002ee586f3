"""The paper's result figures, redrawn: planning time, cost and success against the robots. A
method that found no plan is drawn, too: as a cross."""
import statistics

from matplotlib.lines import Line2D
from matplotlib.ticker import NullLocator

from evaluation import paper, style, svg
from evaluation.svg import plt


def draw(family, groups):
    """Three panels for a family of several sizes, as SVG."""
    groups = [group for group in groups if group.robots]
    figure, panels = plt.subplots(1, 3, figsize=(11, 3.3), constrained_layout=True)
    methods = style.methods_of(groups)
    _titles(panels, groups)
    for i, method in enumerate(methods):
        from_middle = i - (len(methods) - 1) / 2
        own = [group for group in groups if group.method == method]
        _spread_line(panels[0], own, lambda group: group.times, from_middle)
        _spread_line(panels[1], own, lambda group: group.ratios, from_middle)
        _success_line(panels[2], own, from_middle)
        _crosses(panels, own, from_middle)
    panels[0].set_ylim(style.seconds_axis(panels[0].yaxis, panels[0].get_ylim()))
    for limit in sorted({group.time_limit for group in groups if group.failures}):
        panels[0].axhline(limit, color="#888888", linewidth=0.8, linestyle=(0, (2, 2)))
    svg.legend_below(figure, _legend(methods, groups), 9)
    return svg.text_of(figure, f"{family}-robots", f"{family}: planning time, cost over its lower "
                       f"bound and success against the number of robots, a line for each of "
                       f"{', '.join(methods)}")


def _titles(panels, groups):
    panels[0].set(title="Planning time", ylabel="planning time (s)", yscale="log")
    panels[1].set(title="Cost", ylabel="sum of costs / lower bound",
                  ylim=style.cost_limits(groups))
    panels[2].set(title="Success", ylabel="runs with a proved plan (%)", ylim=(-5, 108))
    sizes = sorted({group.robots for group in groups})
    for panel in panels:
        panel.set_xscale("log", base=2)
        panel.set_xticks(sizes, [str(size) for size in sizes])
        panel.xaxis.set_minor_locator(NullLocator())
        panel.set(xlim=(sizes[0] / 1.25, sizes[-1] * 1.25), xlabel="robots")


def _x(group, from_middle):
    """A little aside, so that equal values of several methods do not hide each other."""
    return group.robots * 1.035 ** from_middle


def _spread_line(panel, groups, values_of, from_middle):
    """Median, with a bar from the least to the largest; hollow where some runs failed."""
    groups = [group for group in groups if values_of(group)]
    if not groups:
        return
    color, marker, line = style.of(groups[0].method)
    xs = [_x(group, from_middle) for group in groups]
    middles = [statistics.median(values_of(group)) for group in groups]
    panel.vlines(xs, [min(values_of(group)) for group in groups],
                 [max(values_of(group)) for group in groups], color=color, linewidth=1.2)
    panel.plot(xs, middles, color=color, linestyle=line, linewidth=1.3)
    for x, middle, group in zip(xs, middles, groups):
        panel.plot(x, middle, marker, color=color, markersize=5.5,
                   markerfacecolor=color if group.success == 1 else "white")


def _success_line(panel, groups, from_middle):
    color, marker, line = style.of(groups[0].method)
    panel.plot([_x(group, from_middle) for group in groups],
               [100 * group.success for group in groups], color=color, marker=marker,
               linestyle=line, linewidth=1.3, markersize=5.5)
    for group in groups:
        said = paper.of(group)
        if said and said.success is not None:
            panel.plot(_x(group, from_middle), 100 * said.success, color=color, **style.STAR)


def _crosses(panels, groups, from_middle):
    """A cross where a method solved nothing: at its time limit, and on top of the costs."""
    for group in groups:
        if not group.solved:
            at = {"color": style.color(group.method), "clip_on": False, **style.CROSS}
            x = _x(group, 2 * from_middle)  # since all of them are at the same height
            panels[0].plot(x, group.time_limit, **at)
            panels[1].plot(x, panels[1].get_ylim()[1], **at)


def _legend(methods, groups):
    grey = {"color": "#555555"}
    handles = [Line2D([], [], color=color, marker=marker, linestyle=line, label=method)
               for method, (color, marker, line) in ((one, style.of(one)) for one in methods)]
    if any(group.solved and group.failures for group in groups):
        handles.append(Line2D([], [], marker="o", markerfacecolor="white", linestyle="",
                              label="some runs failed", **grey))
    if any(not group.solved for group in groups):
        handles.append(Line2D([], [], label="no plan in any run", **grey, **style.CROSS))
    if any(group.failures for group in groups):
        handles.append(Line2D([], [], linestyle=(0, (2, 2)), label="time limit", **grey))
    if any(said and said.success is not None for said in map(paper.of, groups)):
        handles.append(Line2D([], [], label="in the paper", **grey, **style.STAR))
    return handles
