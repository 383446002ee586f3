"""Disks in the scenes that the benchmarks of ARC's peers publish: crossings, swaps and halls."""
import math
import random

from families.family import even, families_of, family, require
from families.scene import Scene, number

RADIUS = (0.5, "of each disk, m")


@family("peer-parallel", even(4, 256), file="peer-parallel-{n:03d}", radius=RADIUS,
        pitch=(5.0, "distance between rows, m"),
        jitter=(0.0, "how far a row may lie from its place, m"), seed=(1, "of the jitter"))
def peer_parallel(n, radius, pitch, jitter, seed):
    """The two disks on each of n/2 rows swap ends.

    Rows `pitch` apart, their ends at x = -pitch n/2 and +pitch n/2: many conflicts, each of two
    robots. Source: a peer's "mobile parallel", 4 to 256 robots.
    """
    require(jitter >= 0 < radius and 2 * (radius + jitter) < pitch,
            "disks of neighbouring rows must not touch: radius + jitter below half the pitch")
    draw = random.Random(seed)
    rows = n // 2
    end = pitch * rows
    height = (rows - 1) / 2 * pitch
    wall = max(end, height) + 1 + radius
    scene = Scene(f"{n} disks: rows {number(pitch)} apart, the two of each row swap ends",
                  [[-wall, -wall], [wall, wall]])
    scene.disk("disk", radius)
    for i in range(rows):
        y = -height + i * pitch
        west, east = y + draw.uniform(-jitter, jitter), y + draw.uniform(-jitter, jitter)
        scene.robot(f"west{i}", "disk", [-end, west], [end, west])
        scene.robot(f"east{i}", "disk", [end, east], [-end, east])
    return scene


@family("peer-circle", even(4, 256), file="peer-circle-{n:03d}", radius=RADIUS,
        twist=(0.0, "how far each goal is turned past the opposite disk, rad"))
def peer_circle(n, radius, twist):
    """Disks on a circle swap with the opposite one, all through its middle.

    The circle's radius is 5 n / 2 pi, so that neighbours are 5 m apart along it, and at least 5 m.
    Source: a peer's antipodal swap, 4 to 256 robots.
    """
    circle = max(5.0, 5 * n / (2 * math.pi))
    require(0 < radius < circle * math.sin(math.pi / n),
            "neighbours must not touch: smaller radius")
    wall = circle + 1 + radius
    scene = Scene(f"{n} disks on a circle swap with the opposite one",
                  [[-wall, -wall], [wall, wall]])
    scene.disk("disk", radius)
    for i in range(n):
        start = 2 * math.pi * i / n
        goal = start + math.pi + twist
        scene.robot(f"r{i}", "disk", [circle * math.cos(start), circle * math.sin(start)],
                    [circle * math.cos(goal), circle * math.sin(goal)])
    return scene


@family("peer-inlet", (2,), file="peer-inlet", radius=RADIUS)
def peer_inlet(_n, radius):
    """Two disks swap in a corridor two wide that has a pocket two wide in its middle.

    The corridor is 20 m long. Source: a peer's inlet; wider than the paper's.
    """
    require(0 < radius < 1, "a disk must fit in the corridor, which is 2 m wide: radius below 1")
    scene = Scene("two disks swap in a corridor two wide with a pocket two wide",
                  [[-10, 0], [10, 4]])
    scene.rectangle(-10, 2, -1, 4)
    scene.rectangle(1, 2, 10, 4)
    scene.disk("disk", radius)
    scene.robot("west", "disk", [-9, 1], [9, 1])
    scene.robot("east", "disk", [9, 1], [-9, 1])
    return scene


@family("peer-adaptive", (4, 8, 16), radius=RADIUS)
def peer_adaptive(n, radius):
    """Disks in two crossing corridors with a small open centre and a ring around the blocks.

    18 m square; four blocks, 7 m from the middle, leave corridors two wide. Four disks go from
    beside the centre to the far ends, four the other way, eight swap along the ring. Source: a
    peer's adaptive scene.
    """
    require(0 < radius < 1, "a disk must fit in a corridor, which is 2 m wide: radius below 1")
    scene = Scene(f"{n} disks in crossing corridors two wide with a small centre and an outer ring",
                  [[-9, -9], [9, 9]])
    for sx in (-1, 1):
        for sy in (-1, 1):  # a block with its inner corner cut off, as two rectangles
            for x, y in ((1, 2), (2, 1)):
                (x0, x1), (y0, y1) = sorted((sx * x, sx * 7)), sorted((sy * y, sy * 7))
                scene.rectangle(x0, y0, x1, y1)
    scene.disk("disk", radius)
    ways = []
    directions = ((1, 0), (0, 1), (-1, 0), (0, -1))
    ways += [([3 * x, 3 * y], [-6 * x, -6 * y]) for x, y in directions]
    if n >= 8:
        ways += [([6 * x, 6 * y], [-3 * x, -3 * y]) for x, y in directions]
    if n >= 16:
        for side in (-8, 8):
            ways += [([-6, side], [6, side]), ([6, side], [-6, side]),
                     ([side, -6], [side, 6]), ([side, 6], [side, -6])]
    for i, (start, goal) in enumerate(ways):
        scene.robot(f"r{i}", "disk", start, goal)
    return scene


@family("peer-hallways", even(4, 64), radius=RADIUS)
def peer_hallways(n, radius):
    """The two disks of each of n/2 parallel halls swap ends.

    Halls between racks, 5 m from middle to middle and four radii wide, so that two disks just fail
    to pass within one. Source: a peer's hallways.
    """
    require(0 < radius < 1.25, "racks between the halls need room: radius below 1.25")
    halls = n // 2
    end = halls * 5.0
    rack = 5.0 * halls - 1  # half its length
    thick = (5 - 4 * radius) / 2  # half its width
    wall = end / 2 + 1
    scene = Scene(f"{n} disks swap ends through parallel halls two wide"
                  if radius == 0.5 else f"{n} disks swap ends through parallel halls",
                  [[-wall - 2.5, -end - 1 - radius], [wall + 2.5, end + 1 + radius]])
    racks = [(-halls / 2 + i) * 5.0 for i in range(halls + 1)]
    for x in racks:
        scene.rectangle(x - thick, -rack, x + thick, rack)
    scene.disk("disk", radius)
    for i in range(halls):
        x = (racks[i] + racks[i + 1]) / 2
        scene.robot(f"n{i}", "disk", [x, end], [x, -end])
        scene.robot(f"s{i}", "disk", [x, -end], [x, end])
    return scene


@family("random-crossing", even(8, 1000), file="random-crossing-{n:04d}", radius=RADIUS,
        seed=(1, "of the stations' order"))
def random_crossing(n, radius, seed):
    """Disks cross the floor from shuffled stations on its left and right.

    n/2 go east and n/2 west; each column's heights are spaced evenly and drawn in random order,
    once for starts and once for goals. Width and height grow with n. Source: a peer's random
    crossing.
    """
    rows = n // 2
    reach = max(12.0, 1.2 * rows)
    height = max(6.0, 1.6 * rows / 2)
    require(0 < radius < height / (rows - 1),
            f"neighbours must not touch: radius below {number(height / (rows - 1))}")
    draw = random.Random(seed)

    def heights():
        ys = [-height + 2 * height * i / (rows - 1) for i in range(rows)]
        draw.shuffle(ys)
        return ys

    scene = Scene(f"{n} disks cross the floor from shuffled stations on the left and right",
                  [[-reach - 3, -height - 3], [reach + 3, height + 3]])
    scene.disk("disk", radius)
    for i, (a, b, c, d) in enumerate(zip(heights(), heights(), heights(), heights())):
        scene.robot(f"w{i}", "disk", [-reach, a], [reach, b])
        scene.robot(f"e{i}", "disk", [reach, c], [-reach, d])
    return scene


@family("open-cross", even(2, 32), radius=(0.3, "of each disk, m"),
        pitch=(1.0, "distance between rows, m"), side=(17.0, "of the floor, m"))
def open_cross(n, radius, pitch, side):
    """Half of the disks cross an open floor west-east, half south-north, through its middle.

    n/2 rows and n/2 columns, `pitch` apart, one disk on each: 16 of either fill the 17 m.
    Neighbours go opposite ways. Every disk starts and ends half a pitch from the wall. Source: a
    peer's open cross.
    """
    rows = n // 2
    end, height = (side - pitch) / 2, (rows - 1) * pitch / 2
    require(0 < 2 * radius < pitch, "neighbours must not touch: radius below half the pitch")
    require(radius < math.sqrt(0.5) * (end - height),
            "the last row's end must not touch the last column's: smaller radius, or a larger side")
    scene = Scene(f"{n} disks in rows {number(pitch)} apart: half cross west-east, half "
                  "south-north",
                  [[-side / 2, -side / 2], [side / 2, side / 2]])
    scene.disk("disk", radius)
    for i in range(rows):
        at, way = -height + i * pitch, end if i % 2 == 0 else -end
        scene.robot(f"row{i}", "disk", [-way, at], [way, at])
        scene.robot(f"column{i}", "disk", [at, -way], [at, way])
    return scene


FAMILIES = families_of(vars())
