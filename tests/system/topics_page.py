#!/usr/bin/env python3
"""Checks that docs/topics.md says what idl/fleet.idl and the sources say of the public topics: types,
fields, bounds, units of time, numbers with a name, topics and their quality of service, limits. Each
way: what one has the other must have.

Prints a line for every difference; exits 1 if there is one. Checks itself first, by taking away and
altering what it compares, a line at a time.
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = "docs/topics.md"
IDL = "idl/fleet.idl"
TOPICS = "common/transport/dds/fleet/topics.h"
WIRE = "common/transport/dds/fleet/conversions.h"
FLEET_LIMITS = "common/transport/fleet/fleet_limits.h"
IO_LIMITS = "common/io/limits.h"
ROS = "common/transport/dds/ros/ros_writers.cpp"
# Enumerations: what their constants begin with in the IDL, and where they are in C++.
ENUMERATIONS = {
    "reason": ("REASON_", "common/model/request_state.h", "Rejection"),
    "phase": ("PHASE_", "common/model/request_state.h", "RequestPhase"),
    "status": ("STATUS_", "common/model/plan.h", "PlanStatus"),
}
SOURCES = {PAGE, IDL, TOPICS, WIRE, FLEET_LIMITS, IO_LIMITS, ROS,
           *(header for _, header, _ in ENUMERATIONS.values())}

# Which constant bounds a sequence of the IDL.
BOUNDS = {
    ("PlanRequest", "attachments"): "kAttachments",
    ("PlanRequest", "queries"): "kRobots",
    ("PlanRequest", "solvers"): "kSolvers",
    ("Query", "start"): "kLinks",
    ("Query", "goal"): "kLinks",
    ("Plan", "statistics"): "kStatistics",
    ("Plan", "robots"): "kRobots",
    ("RobotPlan", "times"): "kPathPieceDoubles",
    ("RobotPlan", "configurations"): "kPathPieceDoubles",
    ("RobotPlan", "segments"): "kPathPieceSegments",
    ("Segment", "robots"): "kRobots",
}
# Which constants the rows of the page's table of limits are, in its order.
LIMITS = ["kRequestIdBytes", "kFleetIdBytes", "kFleetNameBytes", "kFleetTextBytes", "kSceneBytes",
          "kAttachmentBytes", "kPathPieceBytes", "kPathPieces", "kPlanWireBytes"]
# Of fleet_limits.h, which the page has in words.
IN_WORDS = {"kSegmentHeadBytes": "32 a segment"}


# ---- The page ----

def cells(row):
    return [cell.strip() for cell in row.strip().strip("|").split("|")]


def tables(lines):
    """Each table's heading's words, the cells of its first row, and those of the others."""
    heading, rows = "", []
    for line in [*lines, ""]:
        if line.startswith("|"):
            rows.append(cells(line))
        elif rows:
            yield heading, rows[0], rows[2:]
            rows = []
        if line.startswith("#"):
            heading = line.lstrip("# ")


def unquoted(cell):
    return cell.strip("`")


def unit_of_time(words):
    return words == "s" or words.startswith("s,")


def read_page(text):
    out = {"types": {}, "topics": {}, "ros": {}, "limits": [], **{name: {} for name in ENUMERATIONS}}
    for heading, head, rows in tables(text.splitlines()):
        if head[0] == "field":
            fields = [(unquoted(name), unquoted(kind), unit_of_time(meaning))
                      for name, kind, meaning in rows]
            for name in heading.split(", "):
                out["types"][name] = fields
        elif head[0] in ENUMERATIONS:
            out[head[0]] = {name: int(number) for number, name, _ in rows}
        elif head[0].startswith("topic "):
            prefix = unquoted(head[0].removeprefix("topic ")).removesuffix("...")
            out["topics"] = {prefix + unquoted(name): tuple(rest) for name, *rest in rows}
        elif head[0] == "topic":
            out["ros"] = {unquoted(name): unquoted(kind) for name, kind, _ in rows}
        elif head[0] == "at most":
            out["limits"] = [int(number) for number, *_ in rows]
    return out


# ---- The IDL ----

def read_idl(text):
    out = {"types": {}, "topics": {}, **{name: {} for name in ENUMERATIONS}}
    topic = struct = None
    for line in text.splitlines():
        if match := re.match(r"// ---- (\S+) ----", line):
            topic = match[1]
        elif match := re.match(r"struct (\w+) {", line):
            struct = match[1]
            out["types"][struct] = []
            out["topics"][topic] = struct  # the last one after the topic's line
        elif match := re.match(r"  (\S.*\S) (\w+);(?:\s*// (.*))?$", line):
            out["types"][struct].append((match[2], match[1], unit_of_time(match[3] or "")))
        elif match := re.match(r"const [a-z ]+ ([A-Z_]+) = (\d+);", line):
            for name, (prefix, _, _) in ENUMERATIONS.items():
                if match[1].startswith(prefix):
                    out[name][match[1].removeprefix(prefix).lower()] = int(match[2])
    return out


# ---- The sources ----

def read_topics(text, wire):
    """By name: type, from whom, the writer's history, the reader's."""
    types = dict(re.findall(r"ACCORD_FLEET_TYPE\((\w+), (\w+)\);", wire))
    prefix = re.search(r'return std::string\("(.*?)"\) \+ topic.name', text)[1]
    out = {}
    for value, name, kind, writer, reader, late in re.findall(
            r'kFleetTopic<(\w+)>\{\s*"(\w+)",\s*FleetTopic::Kind::k(\w+),'
            r'\s*(\d+),\s*(\d+),\s*(\w+)\}', text):
        keep = {"Request": "keep all", "News": "keep last"}[kind]
        durability = {"true": "transient-local", "false": "volatile"}[late]
        out[prefix + name] = (types[value], {"Request": "fleet manager", "News": "service"}[kind],
                              f"{keep}, {writer}", f"{keep}, {reader}; {durability}")
    return out


def read_ros_topics(text):
    """By name, of a robot below /accord: type, as ROS says it."""
    return {f"/accord/ROBOT/{name}": f"{package}/msg/{kind}" for package, kind, name in re.findall(
        r'writer_of<(\w+)::msg::dds_::(\w+)_PubSubType>\(\s*topic \+ "/(\w+)"\)', text)}


def read_user_data(text):
    first, version = re.search(r'return "(.*?)" \+ cluster \+ "(.*?)" \+ role;', text).groups()
    return first + "CLUSTER" + version + re.search(r'kServiceRole = "(.*?)"', text)[1]


def read_enumeration(text, name):
    body = re.search(rf"enum class {name}\b.*?{{(.*?)}};", text, re.DOTALL)[1]
    return {re.sub(r"(?<!^)([A-Z])", r"_\1", word).lower(): int(number)
            for word, number in re.findall(r"\bk(\w+) = (\d+)", body)}


def read_constants(text):
    out = {}
    for name, value in re.findall(r"constexpr std::size_t (k\w+) = ([^;]+);", text):
        value = re.sub(r"std::size_t\{(\d+)\}", r"\1", value).replace("sizeof(double)", "8")
        value = " ".join(value.split())
        value = re.sub(r"(?<=\d)U\b|'", "", value).replace("/", "//")
        out[name] = eval(value, {"__builtins__": {}}, out)  # pylint: disable=eval-used
    return out


# ---- Comparing ----

def difference(what, one, other, names=("the page", "the IDL")):
    """A line for each entry of two maps that is not the same."""
    for key in [*one, *(key for key in other if key not in one)]:
        if one.get(key) != other.get(key):
            yield (f"{what} {key}: {names[0]} has {one.get(key, 'nothing')}, "
                   f"{names[1]} {other.get(key, 'nothing')}")


def flat(types):
    """By type and field: the field's place, IDL type, and whether it is a time."""
    return {f"{name}.{field}": (place, kind, "s" if is_time else "no time")
            for name, fields in types.items()
            for place, (field, kind, is_time) in enumerate(fields)}


def bounds_of(types):
    return {(name, field): int(match[1]) for name, fields in types.items()
            for field, kind, _ in fields if (match := re.search(r", (\d+)>", kind))}


def differences(texts):
    page, idl = read_page(texts[PAGE]), read_idl(texts[IDL])
    yield from difference("field", flat(page["types"]), flat(idl["types"]))
    topics = read_topics(texts[TOPICS], texts[WIRE])
    yield from difference("topic", page["topics"], topics, ("the page", TOPICS))
    yield from difference("topic", idl["topics"], {name: rest[0] for name, rest in topics.items()},
                          ("the IDL", TOPICS))
    for name, (_, header, enumeration) in ENUMERATIONS.items():
        yield from difference(name, page[name], idl[name])
        yield from difference(name, idl[name], read_enumeration(texts[header], enumeration),
                              ("the IDL", header))
    yield from difference("topic of ROS", page["ros"], read_ros_topics(texts[ROS]),
                          ("the page", ROS))
    user_data = read_user_data(texts[TOPICS])
    if f"`{user_data}`" not in texts[PAGE]:
        yield f"user data: the page does not have `{user_data}`"
    yield from limit_differences(texts, page, idl)


def limit_differences(texts, page, idl):
    of_fleet = read_constants(texts[FLEET_LIMITS].replace("limits::", ""))
    constants = {**read_constants(texts[IO_LIMITS]), **of_fleet}
    yield from difference("bound", bounds_of(idl["types"]),
                          {field: constants[name] for field, name in BOUNDS.items()},
                          ("the IDL", "the limits"))
    limits = dict(zip(LIMITS, page["limits"]))
    yield from difference("limit", limits, {name: constants[name] for name in LIMITS},
                          ("the page", "the sources"))
    if len(page["limits"]) > len(LIMITS):
        yield "limit: the page has more than this script knows"
    for name in of_fleet.keys() - {*LIMITS, *BOUNDS.values(), *IN_WORDS}:
        yield f"limit {name}: the page does not have it"
    for name, words in IN_WORDS.items():
        if str(constants[name]) not in words or words not in texts[PAGE]:
            yield f"limit {name}: the page does not say \"{words}\""


# ---- Checking itself ----

def compared_cells(row):
    """How many of a row's cells are compared, from the first."""
    if not row.startswith("| "):
        return 0
    first, *rest = cells(row)
    if first.startswith("`"):
        return 2 if len(rest) == 2 else len(rest) + 1  # a field; a topic
    if first.isdigit():
        return 1 if rest[0] in ("bytes", "pieces") else 2  # a limit; a number with a name
    return 0


def spoiled_row(row):
    """A table's row with each of its cells that are compared altered; nothing where none is."""
    for place in range(compared_cells(row)):
        altered = cells(row)
        altered[place] = re.sub(r"(\w)", r"\g<1>9", altered[place], count=1)
        yield "| " + " | ".join(altered) + " |"
        if compared_cells(row) == 2 and unit_of_time(cells(row)[-1]):
            yield row.replace("| s", "| m", 1)


def spoiled_entry(line):
    """A line of the IDL with each thing that is compared altered; nothing where none is."""
    declaration, _, comment = line.partition("//")
    if re.match(r"  \S.* \w+;|const ", line):
        for word in re.finditer(r"\w+", declaration):
            yield line[:word.end()] + "9" + line[word.end():]
        if unit_of_time(comment.strip()):
            yield line.replace("// s", "// m")
    elif re.match(r"struct |// ---- ", line):
        yield re.sub(r"(\w) (----|{)", r"\g<1>9 \2", line)


def spoiled(text, alter):
    """What was done, and the text with it, for everything that is compared."""
    lines = text.splitlines()
    for number, line in enumerate(lines):
        ways = list(alter(line))
        for way in [*ways, *([None] if ways else [])]:
            kept = [] if way is None else [way]
            yield (f"line {number + 1} {'taken away' if way is None else 'altered to ' + way}",
                   "\n".join([*lines[:number], *kept, *lines[number + 1:]]))


def self_test(texts):
    """How many ways to be wrong it has tried."""
    count = 0
    for path, alter in ((PAGE, spoiled_row), (IDL, spoiled_entry)):
        for what, text in spoiled(texts[path], alter):
            count += 1
            try:
                noticed = any(differences({**texts, path: text}))
            except (KeyError, ValueError, TypeError):  # it is no table or declaration any more
                noticed = True
            assert noticed, f"not noticed: {path}: {what}"
    return count


def main():
    texts = {path: (ROOT / path).read_text() for path in SOURCES}
    found = list(differences(texts))
    print("\n".join(found) or f"{PAGE} and {IDL} agree; {self_test(texts)} ways in which they "
          "might not were noticed")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
