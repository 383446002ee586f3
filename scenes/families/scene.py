"""A scene file (scene/1, see docs/formats.md) as it is put together."""


def number(value):
    """A length (m), an angle (rad) or a time (s) to six decimals, without trailing zeros."""
    text = f"{value:.6f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


def vector(values):
    return "[" + ", ".join(number(value) for value in values) + "]"


class Scene:
    """Obstacles, models and robots in the order in which they were added.

    comment: one line on top of the file. bounds: (least corner, greatest corner) of two numbers
    each for a planar scene, of three for a spatial one; None: unbounded.
    """

    def __init__(self, comment, bounds=None):
        self.comment = comment
        self.bounds = bounds
        self.timestep = 0.1  # s
        self.urdfs = {}  # file name: text, of files that are written beside the scene
        self._obstacles = []
        self._models = []
        self._robots = []

    def obstacle(self, text):
        """Any obstacle, as YAML."""
        self._obstacles.append(text)

    def rectangle(self, x0, y0, x1, y1):
        """The obstacle between two corners of a planar scene."""
        self.obstacle(f"{{box: {vector([x1 - x0, y1 - y0])}, "
                      f"at: {vector([(x0 + x1) / 2, (y0 + y1) / 2])}}}")

    def model(self, name, text):
        """A kind of robot, as YAML."""
        self._models.append(f"{name}: {text}")

    def disk(self, name, radius, speed=1):
        self.model(name, f"{{disk: {number(radius)}, speed: {number(speed)}}}")

    def arm(self, name, urdf):
        """An arm of a Urdf, whose file is written beside the scene."""
        self.urdfs[urdf.file_name] = urdf.text
        self.model(name, f"{{urdf: {urdf.file_name}}}")

    def robot(self, name, model, start, goal, at=None, rpy=None):
        base = f", at: {vector(at)}" if at else ""
        base += f", rpy: {vector(rpy)}" if rpy else ""
        self._robots.append(f"{{name: {name}, model: {model}{base}, start: {vector(start)}, "
                            f"goal: {vector(goal)}}}")

    def text(self, name):
        """The file of this scene under a name."""
        lines = [f"# {self.comment}", "accord: scene/1", f"name: {name}",
                 f"timestep: {number(self.timestep)}", "environment:"]
        if self.bounds:
            lines.append(f"  bounds: [{vector(self.bounds[0])}, {vector(self.bounds[1])}]")
        lines.append("  obstacles:" if self._obstacles else "  obstacles: []")
        lines += [f"    - {obstacle}" for obstacle in self._obstacles]
        lines += ["models:"] + [f"  {model}" for model in self._models]
        lines += ["robots:"] + [f"  - {robot}" for robot in self._robots]
        return "\n".join(lines) + "\n"
