"""Beyond the paper and its peers: warehouses, carts that turn, drones, a mixed cell."""
import math
import random

from families import urdf
from families.family import even, families_of, family, require
from families.scene import Scene

RACK_WIDTH, RACK_HEIGHT, AISLE = 1.0, 6.0, 2.4  # m, of a fleet's warehouse
SPARE = 0.05  # m, at least between a station and a rack or a wall; twice that between stations


class _Stations:
    """Draws places for disks that keep clear of racks, walls and each other."""

    def __init__(self, draw, racks, width, height, radius):
        self._draw, self._racks, self._room = draw, racks, radius + SPARE
        self._width, self._height = width, height

    def take(self, count):
        """`count` places. Throws Impossible where so many do not fit."""
        places, cells, tries = [], {}, 0
        while len(places) < count:
            tries += 1
            require(tries < 400 * count, "so many disks find no room: less density, or radius")
            place = (self._draw.uniform(self._room, self._width - self._room),
                     self._draw.uniform(self._room, self._height - self._room))
            if self._in_rack(place) or self._beside(place, cells):
                continue
            cells.setdefault(self._cell(place), []).append(place)
            places.append(place)
        return places

    def _in_rack(self, place):
        x, y = place
        return any(x0 - self._room < x < x1 + self._room and y0 - self._room < y < y1 + self._room
                   for x0, y0, x1, y1 in self._racks)

    def _cell(self, place):
        side = max(1, math.ceil(2 * self._room))
        return int(place[0]) // side, int(place[1]) // side

    def _beside(self, place, cells):
        column, row = self._cell(place)
        near = (other for i in (-1, 0, 1) for j in (-1, 0, 1)
                for other in cells.get((column + i, row + j), []))
        return any(math.dist(place, other) < 2 * self._room for other in near)


@family("fleet", range(2, 2001), file="fleet-{n:04d}", radius=(0.35, "of each disk, m"),
        density=(0.06, "share of the floor that the disks cover"), seed=(7, "of the stations"))
def fleet(n, radius, density, seed):
    """Disks move between random stations in a warehouse of racks, at constant density.

    Racks of 1 x 6 m, ways of 2.4 m between them; as many as the floor that n disks need has room
    for.
    """
    require(0 < 2 * radius < AISLE - 2 * SPARE, "a disk must fit between two racks, 2.4 m apart")
    require(0 < density < 0.5, "density must be above 0 and below 0.5")
    half = math.sqrt(n * math.pi * radius * radius / density) / 2
    columns = max(1, int((2 * half - AISLE) // (RACK_WIDTH + AISLE)))
    rows = max(1, int((2 * half - AISLE) // (RACK_HEIGHT + AISLE)))
    width = columns * (RACK_WIDTH + AISLE) + AISLE
    height = rows * (RACK_HEIGHT + AISLE) + AISLE
    scene = Scene(f"{n} disks move between random stations in a warehouse of racks",
                  [[0, 0], [width, height]])
    racks = []
    for i in range(columns):
        for j in range(rows):
            x, y = AISLE + i * (RACK_WIDTH + AISLE), AISLE + j * (RACK_HEIGHT + AISLE)
            racks.append((x, y, x + RACK_WIDTH, y + RACK_HEIGHT))
            scene.rectangle(*racks[-1])
    scene.disk("agv", radius, speed=1.5)
    stations = _Stations(random.Random(seed), racks, width, height, radius)
    for i, (start, goal) in enumerate(zip(stations.take(n), stations.take(n))):
        scene.robot(f"r{i:04d}", "agv", start, goal)
    return scene


@family("carts", even(2, 12), file="carts-{n}", circle=(5.0, "radius of the circle, m"))
def carts(n, circle):
    """Carts with headings on a circle change places with the opposite one, around a pillar.

    Every other one is a rectangle, the others are L-shaped; a square pillar stands in the middle.
    """
    require(2 * circle * math.sin(math.pi / n) > 1.8 and circle > 2,
            "neighbours must not touch: a larger circle")
    wall = circle + 3
    scene = Scene(f"{n} rectangular carts (x, y, heading) on a circle change places with the "
                  "opposite one",
                  [[-wall, -wall], [wall, wall]])
    scene.rectangle(-0.6, -0.6, 0.6, 0.6)
    scene.model("cart", "{footprint: [[-0.7, -0.35], [0.7, -0.35], [0.7, 0.35], [-0.7, 0.35]], "
                "speed: 1, turn: 1.2}")
    scene.model("ell", "{footprint: [[-0.6, -0.6], [0.6, -0.6], [0.6, -0.1], [-0.1, -0.1], "
                "[-0.1, 0.6], [-0.6, 0.6]], speed: 1, turn: 1.2}")
    for i in range(n):
        angle = 2 * math.pi * i / n
        x, y = circle * math.cos(angle), circle * math.sin(angle)
        scene.robot(f"c{i}", "cart" if i % 2 == 0 else "ell", [x, y, angle], [-x, -y, angle])
    return scene


@family("drones", even(2, 32), file="drones-{n}", radius=(0.25, "of each drone, m"))
def drones(n, radius):
    """Drones cross a room with pillars, over the wall in its middle.

    10 x 10 x 4 m; half of them start at either side, spread over its width, and go to the point
    across the middle.
    """
    require(0 < radius < 0.5, "a drone must fit between wall and side: radius below 0.5")
    require(n == 2 or 2 * radius < 2 * 9 / (n - 1), "neighbours must not touch: smaller radius")
    scene = Scene(f"{n} drones cross a room with pillars", [[-5, -5, 0], [5, 5, 4]])
    for x in (-2, 2):
        for y in (-2, 2):
            scene.obstacle(f"{{cylinder: {{radius: 0.4, length: 4}}, at: [{x}, {y}, 2]}}")
    scene.obstacle("{box: [10, 0.3, 2.6], at: [0, 0, 1.3]}")
    scene.model("drone", f"{{ball: {radius:g}, speed: 2}}")
    for i in range(n):
        x, y = -4.5 + 9.0 * i / (n - 1), -4.3 if i % 2 == 0 else 4.3
        scene.robot(f"d{i}", "drone", [x, y, 1.0], [-x, -y, 1.0])
    return scene


@family("mixed-cell", (6,), file="mixed-cell")
def mixed_cell(_n):
    """Two six-joint arms swap sides over a bench while four balls pass beside them.

    The arms stand on the bench, face each other and turn their first joints past each other.
    """
    scene = Scene("two arms over a bench and four carts that pass beneath and beside them",
                  [[-4, -4, 0], [4, 4, 3]])
    scene.obstacle("{box: [1.2, 0.6, 0.4], at: [0, 0, 0.2]}")
    scene.arm("arm", urdf.arm6())
    scene.model("drone", "{ball: 0.2, speed: 1.5}")
    out, back = [1.2, 0.5, 0.9, 0, 0.6, 0], [-1.2, 0.5, 0.9, 0, 0.6, 0]
    scene.robot("left", "arm", out, back, at=[-0.42, 0, 0.405])
    scene.robot("right", "arm", back, out, at=[0.42, 0, 0.405], rpy=[0, 0, math.pi])
    for i, (x, y) in enumerate([(-3, -1), (-3, 1), (3, -0.5), (3, 0.5)]):
        scene.robot(f"d{i}", "drone", [x, y, 1.0], [-x, -y, 1.0])
    return scene


FAMILIES = families_of(vars())
