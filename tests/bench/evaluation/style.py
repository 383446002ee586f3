"""How methods look in every figure, and the axes that figures share."""
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from evaluation import rows

# Okabe and Ito's colours, which people with any colour vision tell apart; and markers, for print.
STYLES = {"arc": ("#0072B2", "o", "-"), "decoupled-prm": ("#E69F00", "s", "--"),
          "composite-prm": ("#009E73", "^", "-."), "composite-rrt-connect": ("#CC79A7", "D", ":"),
          "cbs-mp": ("#D55E00", "v", (0, (5, 1, 1, 1, 1, 1)))}
CROSS = {"marker": "x", "markersize": 7, "markeredgewidth": 2, "linestyle": ""}  # no plan at all
STAR = {"marker": "*", "markersize": 11, "markerfacecolor": "none", "linestyle": ""}  # the paper's


def of(method):
    """Colour, marker and line."""
    return STYLES.get(method, ("#555555", "P", "-"))


def color(method):
    return of(method)[0]


def methods_of(groups):
    """In their usual order."""
    found = {group.method for group in groups}
    return [method for method in rows.METHODS if method in found]


def seconds_axis(axis, limits):
    """Ticks for a logarithmic axis, at least a decade around what is drawn; its new limits."""
    low, high = limits
    if high < 10 * low:
        middle = (low * high) ** 0.5
        low, high = middle / 10 ** 0.5, middle * 10 ** 0.5
    axis.set_major_locator(LogLocator(subs=(1, 2, 5) if high < 100 * low else (1,)))
    axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axis.set_minor_formatter(NullFormatter())
    return low, high


def cost_limits(groups):
    """From the bound itself to the largest ratio, so that small differences look small."""
    ratios = [ratio for group in groups for ratio in group.ratios] or [1.0]
    high = max(1.1, max(ratios))
    return min(1.0, *ratios) - 0.04 * (high - 1), high + 0.04 * (high - 1)
