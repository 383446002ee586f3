#!/usr/bin/env python3
"""Checks that deploy/monitoring/ and docs/operations.md name the metrics, labels and values of labels
that a coordinator, a worker and a discovery server have, and that the page names all of them: each way for the page, which
process has what, too.

Prints a line for every difference; exits 1 if there is one. Checks itself first, by altering each name
that is compared, one at a time.
"""

import json
import re
import sys

import scrape

PAGE = "docs/operations.md"
RULES = "deploy/monitoring/alerts.yaml"
DASHBOARD = "deploy/monitoring/accord-dashboard.json"

# What Prometheus itself adds: the target's labels, of which the scrape config has cluster, the
# buckets' bounds, and whether it could be scraped.
OF_TARGETS = {"cluster", "job", "instance"}
OF_PROMETHEUS = {"up"}
WORDS = {"by", "without", "on", "ignoring", "group_left", "group_right"}
AGGREGATIONS = {"sum", "max", "min", "avg", "count"}
NO_METRICS = AGGREGATIONS | {"and", "or", "unless", "bool", "offset"}
TOKEN = re.compile(r'"[^"]*"|\$?[A-Za-z_]\w*|\d[\w.]*|[{}()\[\]]|=~|!~|!=|=|\S')


# ---- PromQL, as far as names go ----

def tokens_of(expression):
    return TOKEN.findall(re.sub(r"\[[^\]]*\]", "", expression))


def is_name(token):
    return re.fullmatch(r"[A-Za-z_]\w*", token) is not None


def read_expression(expression):
    """The selectors, as name and matchers (label, operator, value), and the labels that it groups
    by or joins on."""
    tokens = tokens_of(expression)
    selectors, grouped = [], set()
    place = 0
    while place < len(tokens):
        token, following = tokens[place], tokens[place + 1] if place + 1 < len(tokens) else ""
        place += 1
        if token in WORDS and following == "(":
            end = tokens.index(")", place)
            grouped |= {label for label in tokens[place + 1:end] if is_name(label)}
            place = end + 1
        elif is_name(token) and following != "(" and token not in NO_METRICS:
            matchers = []
            if following == "{":
                end = tokens.index("}", place)
                inside = [t for t in tokens[place + 1:end] if t != ","]
                matchers = [(label, operator, value.strip('"')) for label, operator, value
                            in zip(inside[::3], inside[1::3], inside[2::3], strict=True)]
                place = end + 1
            selectors.append((token, matchers))
    return selectors, grouped


class Known:
    """All metrics there are, whichever process has them."""

    def __init__(self, processes):
        self.labels = {}
        for metrics in processes.values():
            for name, metric in metrics.items():
                for series in self.series_of(name, metric.kind):
                    known = self.labels.setdefault(series, {})
                    for label, values in metric.labels.items():
                        if label != "le" or series.endswith("_bucket"):
                            known.setdefault(label, set()).update(values)

    @staticmethod
    def series_of(name, kind):
        return [name + suffix for suffix in ("_bucket", "_sum", "_count")] \
            if kind == "histogram" else [name]

    def faults(self, expression):
        selectors, grouped = read_expression(expression)
        labels = set(OF_TARGETS)
        for name, matchers in selectors:
            if name in OF_PROMETHEUS:
                yield from (f"{name} has no label {label}" for label, _, _ in matchers
                            if label not in OF_TARGETS)
                continue
            if name not in self.labels:
                yield f"there is no metric {name}"
                continue
            labels |= self.labels[name].keys()
            for matcher in matchers:
                yield from self.matcher_faults(name, *matcher)
        yield from (f"no metric in it has a label {label}" for label in sorted(grouped - labels))

    def matcher_faults(self, name, label, operator, value):
        if label in OF_TARGETS:
            return
        known = self.labels[name].get(label)
        if known is None:
            yield f"{name} has no label {label}"
            return
        wanted = value.split("|") if operator in ("=~", "!~") else [value]
        yield from (f"{name} has no {label}=\"{one}\"" for one in wanted if one not in known)

    def label_faults(self, expression, labels):
        """Labels that a legend or a sentence takes from an expression's result."""
        selectors, grouped = read_expression(expression)
        there = OF_TARGETS | grouped
        if not AGGREGATIONS & set(tokens_of(expression)):
            there |= {label for name, _ in selectors for label in self.labels.get(name, ())}
        yield from (f"its result has no label {label}" for label in labels if label not in there)


# ---- What is compared ----

def dashboard_faults(text, known):
    dashboard = json.loads(text)
    for panel in dashboard["panels"]:
        for target in panel.get("targets", []):
            where = f"{DASHBOARD}: {panel['title']}: {target['expr']}"
            for fault in known.faults(target["expr"]):
                yield f"{where}: {fault}"
            legend = re.findall(r"{{\s*(\w+)\s*}}", target["legendFormat"])
            for fault in known.label_faults(target["expr"], legend):
                yield f"{where}: legend: {fault}"
    variables = {variable["name"] for variable in dashboard["templating"]["list"]}
    for used in re.findall(r"\$\{?(\w+)", text):
        if used not in variables and not used.startswith("__"):
            yield f"{DASHBOARD}: there is no variable ${used}"
    for variable in dashboard["templating"]["list"]:
        for metric, label in re.findall(r"label_values\((\w+)(?:{.*})?, (\w+)\)",
                                        variable.get("definition", "")):
            if metric not in known.labels or label not in OF_TARGETS:
                yield f"{DASHBOARD}: ${variable['name']}: no {metric} with {label}"


def read_rules(text):
    """By name: the expression, and the labels that its words take. promtool reads the rest."""
    rules = {}
    for block in re.split(r"(?m)^      - alert: ", text)[1:]:
        name = block.split("\n", 1)[0]
        expression = re.search(r"(?ms)^        expr: (?:>-\n)?(.*?)(?=^        \w)", block)[1]
        rules[name] = (" ".join(expression.split()), set(re.findall(r"\$labels\.(\w+)", block)),
                       block)
    return rules


def rule_faults(text, known):
    for name, (expression, labels, block) in read_rules(text).items():
        for fault in [*known.faults(expression), *known.label_faults(expression, labels)]:
            yield f"{RULES}: {name}: {fault}"
        for part in ("severity: ", "summary: ", "description: ", "runbook: docs/operations.md#"):
            if part not in block:
                yield f"{RULES}: {name}: no {part.split(':')[0]}"
        for metric in re.findall(r"\b(?:accord|process)_\w+", block):
            if metric not in known.labels:
                yield f"{RULES}: {name}: there is no metric {metric}"


def section_of(page, heading):
    return re.search(rf"(?ms)^## {heading}$(.*?)(?=^## |\Z)", page)[1]


def documented_metrics(page):
    """By process: the page's metrics, as names with the names of their labels."""
    out = {"coordinator": set(), "worker": set(), "discovery": set()}
    processes = ()
    for line in section_of(page, "Metrics").splitlines():
        if heading := re.match(r"\| of (all|coordinators and workers|a coordinator|a worker|a discovery server) \|", line):
            processes = {"all": tuple(out), "coordinators and workers": ("coordinator", "worker"),
                         "a coordinator": ("coordinator",), "a worker": ("worker",),
                         "a discovery server": ("discovery",)}[heading[1]]
        elif line.startswith("| `"):
            for process in processes:
                out[process].update(re.findall(r"`([^`]+)`", line.split("|")[1]))
    return out


def written(name, metric):
    labels = sorted(metric.labels.keys() - {"le"})
    return name + ("{" + ",".join(labels) + "}" if labels else "")


def page_faults(page, rules, processes):
    documented = documented_metrics(page)
    for process, metrics in processes.items():
        there = {written(name, metric) for name, metric in metrics.items()}
        for name in sorted(there - documented[process]):
            yield f"{PAGE}: does not have {name} of a {process}"
        for name in sorted(documented[process] - there):
            yield f"{PAGE}: a {process} has no {name}"
    alerts = set(re.findall(r"(?m)^\| `(\w+)` \|", section_of(page, "Alerts")))
    for name in sorted(read_rules(rules).keys() ^ alerts):
        yield f"{PAGE}: alert {name} is not both there and in {RULES}"


def faults(texts, processes):
    known = Known(processes)
    yield from page_faults(texts[PAGE], texts[RULES], processes)
    yield from rule_faults(texts[RULES], known)
    yield from dashboard_faults(texts[DASHBOARD], known)


# ---- Checking itself ----

# What is compared in rules, and in a target of the dashboard.
IN_RULES = re.compile(r"(?:accord|process)_\w+|(?<=[{|,])\w+(?==)|(?<=\")[a-z_]+(?=[|\"])"
                      r"|(?<=by \()\w+|(?<=labels\.)\w+|(?<=- alert: )\w+")
IN_TARGETS = re.compile(r"accord_\w+|process_\w+|(?<=,)(?!cluster|job|instance)\w+(?==)"
                        r"|(?<=bus=\\\")\w+|(?<={{)\w+")


def compared_parts(path, text):
    """Pieces of a text, and what is compared in each."""
    if path == PAGE:
        for heading in ("Metrics", "Alerts"):
            for row in re.findall(r"(?m)^\| `\w.*$", section_of(text, heading)):
                end = row.index(" |") if heading == "Metrics" else row.index("` |")
                yield row[:end], re.compile(r"\w+")
    elif path == RULES:
        yield text, IN_RULES
    else:
        for panel in json.loads(text)["panels"]:
            for target in panel.get("targets", []):
                yield json.dumps(target)[1:-1], IN_TARGETS


def spoiled(path, text):
    """What was done, and the text with it, for each name that is compared."""
    for part, pattern in compared_parts(path, text):
        for match in pattern.finditer(part):
            altered = part[:match.end()] + "9" + part[match.end():]
            yield f"{match[0]} in {part[:60].strip()!r}", text.replace(part, altered, 1)


def self_test(texts, processes):
    """How many ways to be wrong it has tried."""
    count = 0
    flat = json.dumps(json.loads(texts[DASHBOARD]))
    for path in texts:
        text = flat if path == DASHBOARD else texts[path]
        for what, wrong in spoiled(path, text):
            count += 1
            assert any(faults({**texts, path: wrong}, processes)), f"not noticed: {path}: {what}"
    for process, metrics in processes.items():
        for name in metrics:
            count += 1
            less = {key: value for key, value in metrics.items() if key != name}
            assert any(faults(texts, {**processes, process: less})), f"not noticed: no {name}"
    return count


def main():
    texts = {path: (scrape.ROOT / path).read_text() for path in (PAGE, RULES, DASHBOARD)}
    processes = scrape.scrape()
    found = list(faults(texts, processes))
    print("\n".join(found) or f"{PAGE}, {RULES} and {DASHBOARD} agree with what is served; "
          f"{self_test(texts, processes)} ways in which they might not were noticed")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
