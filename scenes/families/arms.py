"""Arms: the three scenarios of the ARC paper (Solis et al., 2023, section V-B), modelled on its
figures, and the crossing of planar arms that a peer's benchmark has; and many pairs that have nothing to do with each other."""
import math
import random

from families import urdf
from families.family import even, families_of, family, require
from families.scene import Scene


@family("low-manipulator", range(2, 17),
        spacing=(0.62, "distance of neighbouring bases, m; at least 0.8 for 5 to 7 arms"),
        lean=(0.9, "first joint's angle to the ring's tangent at both ends, rad"))
def low_manipulator(n, spacing, lean):
    """Low coordination: a ring of six-joint arms untangles.

    Bases on a ring with their x axes along its tangent, at least 0.45 m from the middle; each arm
    leans over the neighbour on one side and must lean over the other. Unbounded. Paper: scenario
    I, up to 16 robots.
    """
    require(spacing > 0.15, "bases are 0.15 m thick: spacing must be more")
    require(0 <= lean <= 3.1, "lean must be within the joint's limits, 0 to 3.1 rad")
    if 5 <= n <= 7:  # elbows of neighbours come closest in rings of these sizes
        spacing = max(spacing, 0.8)
    ring = max(0.45, spacing / (2 * math.sin(math.pi / n)))
    scene = Scene(f"{n} six-joint arms in a ring lean over one neighbour and must lean over the "
                  "other")
    scene.arm("arm", urdf.arm6())
    rest = [0.55, 0.9, 0, 0.6, 0]
    for i in range(n):
        angle = 2 * math.pi * i / n
        scene.robot(f"arm{i}", "arm", [math.pi - lean] + rest, [lean] + rest,
                    at=[ring * math.cos(angle), ring * math.sin(angle), 0],
                    rpy=[0, 0, angle + math.pi / 2])
    return scene


@family("high-manipulator", even(2, 16), file="high-manipulator-{n}",
        gap=(2.6, "distance of the facing bases, m"),
        pitch=(3.4, "distance of neighbouring bases, m"),
        lean=(1.2, "angle of both ends to the middle, rad"),
        link=(1.0, "length of each link, m"))
def high_manipulator(n, gap, pitch, lean, link):
    """High coordination: planar three-joint arms opposite each other pass with hardly any room.

    n/2 arms on the top and n/2 on the bottom wall of a hall `gap` high; the top ones swing right,
    the bottom ones left, and have to contract to pass. Paper: scenario II, 2 and 4 robots.
    """
    require(min(gap, pitch, link) > 0.12,
            "gap, pitch and link must be more than the links' width, 0.12 m")
    require(0 <= lean <= math.pi / 2, "lean must be from 0 to pi/2")
    pairs = n // 2
    half = (pairs - 1) * pitch / 2 + 4.2
    scene = Scene(f"{n} planar 3-joint arms face each other; the top ones swing right, the bottom "
                  "ones left",
                  [[-half, -gap / 2 - 0.4], [half, gap / 2 + 0.4]])
    scene.arm("arm", urdf.planar(link))
    for i in range(pairs):
        x = -(pairs - 1) * pitch / 2 + i * pitch
        # The first joint is measured from the base's x axis, which points into the hall.
        scene.robot(f"top{i}", "arm", [-lean, 0, 0], [lean, 0, 0], at=[x, gap / 2, 0],
                    rpy=[0, 0, -math.pi / 2])
        scene.robot(f"bottom{i}", "arm", [-lean, 0, 0], [lean, 0, 0], at=[x, -gap / 2, 0],
                    rpy=[0, 0, math.pi / 2])
    return scene


@family("adaptive-manipulator", (8,), file="adaptive-manipulator",
        inner=(2.2, "radius of the circle of inner bases, m"),
        outer=(5.6, "radius of the circle of outer bases, m"))
def adaptive_manipulator(_n, inner, outer):
    """Adaptive coordination: four inner planar arms clash with four outer ones, then meet.

    Inner bases on a small circle: from pointing outwards to pointing past the centre; outer bases
    on a large one, swinging across the inner ones' starts. Paper: scenario III, 8 robots.
    """
    require(0 < inner < outer, "inner must be less than outer")
    scene = Scene("eight planar 3-joint arms: the four inner ones first clash with the outer ones, "
                  "then meet in the centre",
                  [[-outer - 0.5, -outer - 0.5], [outer + 0.5, outer + 0.5]])
    scene.arm("arm", urdf.planar())
    for i in range(4):
        angle = math.pi / 2 * i + math.pi / 4
        x, y = math.cos(angle), math.sin(angle)
        scene.robot(f"inner{i}", "arm", [0.15, 0.2, 0], [math.pi - 0.75, 0.7, 0.5],
                    at=[inner * x, inner * y, 0], rpy=[0, 0, angle])
        scene.robot(f"outer{i}", "arm", [0.9, 0.3, 0], [-0.9, -0.3, 0],
                    at=[outer * x, outer * y, 0], rpy=[0, 0, angle + math.pi])
    return scene


@family("planar-cross", even(4, 128), file="peer-planar-cross-{n:03d}",
        spacing=(1.35, "distance of the two lines, m"),
        pitch=(1.2, "distance of bases in a line, m"),
        link=(0.3, "length of each link, m"))
def planar_cross(n, spacing, pitch, link):
    """Two facing lines of planar three-joint arms swing through each other.

    n/2 arms a line; each turns its first joint from pi/6 to -pi/6 with the others stretched, and
    meets the one opposite. Source: a peer's benchmark, which goes up to 128 arms.
    """
    require(min(spacing, pitch, link) > 0.1,
            "spacing, pitch and link must be more than the links' width, 0.1 m")
    rows = n // 2
    low = -(rows - 1) / 2 * pitch
    x, half = spacing / 2, (rows - 1) / 2 * pitch + pitch
    scene = Scene(f"{n} planar 3-joint arms in two facing lines swing from +30 to -30 degrees",
                  [[-x - 0.11, -half], [x + 0.11, half]])
    scene.arm("arm", urdf.planar(link, 0.1))
    start, goal = [math.pi / 6, 0, 0], [-math.pi / 6, 0, 0]
    for i in range(rows):
        y = low + pitch * i
        scene.robot(f"left{i}", "arm", start, goal, at=[-x, y, 0])
        scene.robot(f"right{i}", "arm", start, goal, at=[x, y, 0], rpy=[0, 0, math.pi])
    return scene


@family("arm-cells", even(2, 512), file="arm-cells-{n:03d}",
        gap=(2.6, "distance of the facing bases, m"), link=(1.0, "length of each link, m"),
        seed=(1, "of how far each pair leans"))
def arm_cells(n, gap, link, seed):
    """Pairs of planar arms, each pair in a cell of its own, pass with hardly any room.

    n/2 of high-manipulator's pairs in walled cells on a grid, out of each other's reach, each with
    another angle to the middle, 1.1 to 1.3 rad: as many hard conflicts that have nothing to do
    with each other. For how planning scales with workers.
    """
    require(min(gap, link) > 0.12, "gap and link must be more than the links' width, 0.12 m")
    draw = random.Random(seed)
    pairs = n // 2
    columns = math.ceil(math.sqrt(pairs))
    rows = math.ceil(pairs / columns)
    wall = 0.1
    # An arm's reach and its base to each side, and from its base to the farther wall and beyond.
    half_width, half_height = 3 * link + 1.2, gap / 2 + 0.4
    pitch_x = 2 * half_width + wall
    pitch_y = gap + 3 * link + 1.4
    low_x, low_y = -(columns - 1) * pitch_x / 2, -(rows - 1) * pitch_y / 2
    edge_x, edge_y = -low_x + half_width + wall, -low_y + half_height + wall
    scene = Scene(f"{pairs} cells, in each two planar 3-joint arms that face each other and swing "
                  "to opposite sides",
                  [[-edge_x, -edge_y], [edge_x, edge_y]])
    scene.arm("arm", urdf.planar(link))
    for i in range(pairs):
        x, y = low_x + i % columns * pitch_x, low_y + i // columns * pitch_y
        left, right, low, high = x - half_width, x + half_width, y - half_height, y + half_height
        scene.rectangle(left - wall, low - wall, right + wall, low)
        scene.rectangle(left - wall, high, right + wall, high + wall)
        scene.rectangle(left - wall, low, left, high)
        scene.rectangle(right, low, right + wall, high)
        lean = draw.uniform(1.1, 1.3)
        scene.robot(f"top{i}", "arm", [-lean, 0, 0], [lean, 0, 0], at=[x, y + gap / 2, 0],
                    rpy=[0, 0, -math.pi / 2])
        scene.robot(f"bottom{i}", "arm", [-lean, 0, 0], [lean, 0, 0], at=[x, y - gap / 2, 0],
                    rpy=[0, 0, math.pi / 2])
    return scene


FAMILIES = families_of(vars())
