"""Matplotlib's figures as SVG that can stand in a page, the same bytes for the same figure."""
import io
import re

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402  (after the choice of what draws)

plt.rcParams.update({
    "svg.hashsalt": "accord",  # for the same ids every time
    "svg.fonttype": "none",  # text stays text, so that it can be read aloud and searched
    "font.family": "sans-serif", "font.sans-serif": ["DejaVu Sans", "Arial", "Helvetica"],
    "font.size": 9, "axes.titlesize": 10, "axes.titlepad": 9,
    "axes.spines.top": False, "axes.spines.right": False,
    "axes.grid": True, "grid.color": "#e4e4e4", "axes.axisbelow": True, "legend.frameon": False,
    "hatch.linewidth": 0.6})


def legend_below(figure, handles, columns):
    """Beneath all panels, where it hides nothing."""
    figure.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, 0), fontsize=8,
                  ncols=min(len(handles), columns), handlelength=2.6, columnspacing=1.4)


def text_of(figure, name, description):
    """The <svg> element. name: a word that no other figure of the page has, since it keeps their
    ids apart. description: what one sees, for those who do not."""
    out = io.StringIO()
    figure.savefig(out, format="svg", metadata={"Date": None, "Creator": None},
                   bbox_inches="tight")
    plt.close(figure)
    return for_page(out.getvalue(), name, description)


def for_page(svg, name, description):
    """An SVG file as an element of a page: no prologue, no ids that another figure has, a label."""
    svg = svg[svg.index("<svg"):]
    svg = re.sub(r"<metadata>.*?</metadata>", "", svg, flags=re.DOTALL)
    svg = re.sub(r'\bid="', f'id="{name}-', svg)
    svg = re.sub(r'href="#', f'href="#{name}-', svg)
    svg = re.sub(r"url\(#", f"url(#{name}-", svg)
    label = description.replace("&", "&amp;").replace('"', "&quot;").replace("<", "&lt;")
    return svg.replace("<svg", f'<svg role="img" aria-label="{label}"', 1).strip()
