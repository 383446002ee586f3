"""HTML: tables, figures and the page around them. Texts are escaped here and nowhere else."""
from html import escape

STYLE = """
body { font: 15px/1.5 system-ui, "DejaVu Sans", Arial, sans-serif; color: #1c1c1c;
       margin: 2rem auto; max-width: 82rem; padding: 0 1rem; }
h1 { font-size: 1.8rem; } h2 { margin-top: 2.5rem; border-bottom: 1px solid #ccc; }
table { border-collapse: collapse; font-size: 12.5px; font-variant-numeric: tabular-nums; }
th, td { padding: .25rem .5rem; border-bottom: 1px solid #e2e2e2; text-align: left;
         vertical-align: bottom; }
td { vertical-align: top; }
th { border-bottom: 2px solid #888; }
td.number, th.number { text-align: right; } td.number, td.name { white-space: nowrap; }
caption { text-align: left; color: #444; padding: .4rem 0; }
.wide { overflow-x: auto; } figure { margin: 1rem 0; } figure svg { max-width: 100%; height: auto; }
figcaption, .note { color: #444; font-size: 13px; }
.yes { color: #00603f; font-weight: bold; } .no { color: #a83200; font-weight: bold; }
code { font-size: 12px; overflow-wrap: anywhere; } nav a { margin-right: .8rem; }
.picture svg { max-height: 22rem; width: auto; }
"""


class Cell:
    """A table's cell with a class: number, name, yes or no."""

    def __init__(self, text, kind=""):
        self.text, self.kind = str(text), kind


def number(text):
    return Cell(text, "number")


def name(text):
    """A text that stays on one line."""
    return Cell(text, "name")


def _cell(tag, cell):
    cell = cell if isinstance(cell, Cell) else Cell(cell)
    kind = f' class="{cell.kind}"' if cell.kind else ""
    return f"<{tag}{kind}>{escape(cell.text)}</{tag}>"


def table(caption, head, lines):
    """lines: lists of texts or Cells. A column's head stands as its first cell does."""
    kinds = [cell.kind if isinstance(cell, Cell) else "" for cell in (lines or [head])[0]]
    heads = [Cell(text, "number" if kind == "number" else "") for text, kind in zip(head, kinds)]
    out = ['<div class="wide"><table>', f"<caption>{escape(caption)}</caption>", "<thead><tr>",
           *(_cell("th", cell) for cell in heads), "</tr></thead>", "<tbody>"]
    for line in lines:
        out.append("<tr>" + "".join(_cell("td", cell) for cell in line) + "</tr>")
    return "\n".join(out + ["</tbody></table></div>"])


def figure(svg, caption, kind=""):
    attribute = f' class="{kind}"' if kind else ""
    return f"<figure{attribute}>{svg}<figcaption>{escape(caption)}</figcaption></figure>"


def paragraph(text):
    return f"<p>{escape(text)}</p>"


def heading(text, anchor, rank=2):
    return f'<h{rank} id="{escape(anchor)}">{escape(text)}</h{rank}>'


def links(names):
    """names: (anchor, text)."""
    return "<nav>" + " ".join(f'<a href="#{escape(anchor)}">{escape(text)}</a>'
                              for anchor, text in names) + "</nav>"


def document(title, parts):
    body = "\n".join(parts)
    return (f'<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
            f'<meta name="viewport" content="width=device-width, initial-scale=1">\n'
            f"<title>{escape(title)}</title>\n<style>{STYLE}</style>\n</head>\n<body>\n"
            f"<h1>{escape(title)}</h1>\n{body}\n</body>\n</html>\n")
