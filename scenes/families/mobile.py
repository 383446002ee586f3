"""Mobile robots in the three scenarios of the ARC paper (Solis, Motes, Qin, Morales, Amato, 2023,
section V-B), modelled on its figures: the paper gives no measures."""
from families.family import even, families_of, family, require
from families.scene import Scene


@family("low-mobile", even(2, 64), radius=(0.5, "of each disk, m"),
        pitch=(1.5, "distance between rows, m"), reach=(8.0, "half the way of each disk, m"))
def low_mobile(n, radius, pitch, reach):
    """Low coordination: the two disks on each row switch positions.

    n/2 rows, `pitch` apart, with a disk at x = -reach and one at x = +reach on each; three metres
    around them. No obstacles. Paper: scenario I, 8, 16 and 32 robots.
    """
    require(0 < 2 * radius < pitch, "neighbours must not touch: radius below half the pitch")
    require(reach > radius, "the two disks of a row must not touch: reach above radius")
    rows = n // 2
    height = (rows - 1) * pitch / 2
    scene = Scene(f"{n} disks: the two on each row switch positions",
                  [[-reach - 3, -height - 3], [reach + 3, height + 3]])
    scene.disk("agv", radius)
    for i in range(rows):
        y = -height + i * pitch
        scene.robot(f"west{i}", "agv", [-reach, y], [reach, y])
        scene.robot(f"east{i}", "agv", [reach, y], [-reach, y])
    return scene


@family("high-mobile", (2,), file="high-mobile", radius=(0.5, "of each disk, m"),
        width=(1.2, "of the corridor, m"), length=(12.0, "of the corridor, m"),
        inlet=(1.2, "width of the inlet, m"), depth=(1.3, "of the inlet, m"))
def high_mobile(_n, radius, width, length, inlet, depth):
    """High coordination: two disks swap the ends of a corridor with one inlet.

    The corridor is one robot wide; the inlet opens in the middle of its north wall. Paper:
    scenario II, 2 robots.
    """
    require(0 < 2 * radius < min(width, inlet, depth),
            "a disk must fit in corridor and inlet: radius below half of width, inlet and depth")
    half, w, end = length / 2, width / 2, length / 2 - radius - 0.1
    require(end - radius > inlet / 2, "each disk must start beside the inlet: a longer corridor")
    scene = Scene("two disks swap the ends of a corridor one robot wide; its only inlet is in "
                  "the middle",
                  [[-half, -w - 0.5], [half, w + depth + 0.5]])
    scene.rectangle(-half, -w - 0.5, half, -w)
    scene.rectangle(-half, w, -inlet / 2, w + depth + 0.5)
    scene.rectangle(inlet / 2, w, half, w + depth + 0.5)
    scene.rectangle(-inlet / 2, w + depth, inlet / 2, w + depth + 0.5)
    scene.disk("agv", radius)
    scene.robot("west", "agv", [-end, 0], [end, 0])
    scene.robot("east", "agv", [end, 0], [-end, 0])
    return scene


@family("adaptive-mobile", range(4, 65, 4),
        file=lambda n: "adaptive-mobile" if n == 16 else f"adaptive-mobile-{n:02d}",
        radius=(0.5, "of each disk, m"),
        width=(1.5, "of an aisle, m"), block=(2.0, "side of a rack, m"),
        margin=(2.2, "width of the way around, m"))
def adaptive_mobile(n, radius, width, block, margin):
    """Adaptive coordination: disks at the two ends of each aisle of a warehouse switch positions.

    n/4 aisles each way between square racks, one robot wide, and a way around all of them. Two
    robots meet along an aisle, four where aisles cross. Paper: scenario III, 16 robots.
    """
    require(0 < 2 * radius < min(width, margin),
            "a disk must fit in an aisle and around: radius below half of width and margin")
    aisles = n // 4
    half = (aisles * width + (aisles + 1) * block) / 2
    scene = Scene(f"{n} disks in a warehouse: those at the two ends of an aisle switch positions; "
                  "aisles are one robot wide",
                  [[-half - margin, -half - margin], [half + margin, half + margin]])
    for i in range(aisles + 1):
        for j in range(aisles + 1):
            x, y = -half + i * (block + width), -half + j * (block + width)
            scene.rectangle(x, y, x + block, y + block)
    scene.disk("agv", radius)
    end = half + margin / 2
    for i in range(aisles):
        middle = -half + block + width / 2 + i * (block + width)
        scene.robot(f"south{i}", "agv", [middle, -end], [middle, end])
        scene.robot(f"north{i}", "agv", [middle, end], [middle, -end])
        scene.robot(f"west{i}", "agv", [-end, middle], [end, middle])
        scene.robot(f"east{i}", "agv", [end, middle], [-end, middle])
    return scene


FAMILIES = families_of(vars())
