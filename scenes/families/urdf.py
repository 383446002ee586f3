"""The arms' URDF files."""
import dataclasses

from families.scene import number


@dataclasses.dataclass(frozen=True)
class Urdf:
    file_name: str
    text: str


def _origin(xyz):
    return f'<origin xyz="{xyz}" rpy="0 0 0"/>'


def _link(name, origin, shape):
    return f'''  <link name="{name}">
    <collision>{origin}<geometry>{shape}</geometry></collision>
  </link>
'''


def _joint(name, parent, child, xyz, axis, limits, speed):
    lower, upper = limits
    return f'''  <joint name="{name}" type="revolute">
    <parent link="{parent}"/><child link="{child}"/>{_origin(xyz)}<axis xyz="{axis}"/>
    <limit lower="{lower}" upper="{upper}" velocity="{speed}" effort="100"/>
  </joint>
'''


def _cylinder_link(name, radius, length):
    shape = f'<cylinder radius="{number(radius)}" length="{number(length)}"/>'
    return _link(name, _origin(f"0 0 {number(length / 2)}"), shape)


def _bar_link(name, length, width):
    shape = f'<box size="{number(length)} {number(width)} {number(width)}"/>'
    return _link(name, f'<origin xyz="{number(length / 2)} 0 0"/>', shape)


def planar(length=1.0, width=0.12):
    """Three bars of a length and a width (m), each turning about z at the end of the one before."""
    names = {(1.0, 0.12): "planar3.urdf", (0.3, 0.1): "planar3s.urdf"}
    file_name = names.get((length, width), f"planar3-{number(length)}x{number(width)}.urdf")
    text = ('<?xml version="1.0"?>\n<!-- planar arm of 3 revolute joints about z -->\n'
            '<robot name="planar3">\n  <link name="base"/>\n')
    text += _bar_link("link1", length, width)
    text += _joint("joint1", "base", "link1", "0 0 0", "0 0 1", (-3.1, 3.1), 1.0)
    for i in (2, 3):
        text += _bar_link(f"link{i}", length, width)
        text += _joint(f"joint{i}", f"link{i - 1}", f"link{i}", f"{number(length)} 0 0", "0 0 1",
                       (-2.6, 2.6), 1.0)
    return Urdf(file_name, text + "</robot>\n")


def arm6():
    """Six revolute joints, reach about 0.95 m, of the proportions of a light industrial arm."""
    text = ('<?xml version="1.0"?>\n<!-- six-joint arm: yaw, pitch, pitch, roll, pitch, roll; '
            'reach 0.95 m -->\n<robot name="arm6">\n')
    for name, radius, length in (("base", 0.075, 0.12), ("shoulder", 0.07, 0.10),
                                 ("upper", 0.055, 0.40), ("fore", 0.045, 0.20),
                                 ("roll", 0.04, 0.16), ("wrist", 0.035, 0.10),
                                 ("tool", 0.03, 0.09)):
        text += _cylinder_link(name, radius, length)
    for name, parent, child, height, axis, limit, speed in (
            ("yaw", "base", "shoulder", "0.13", "0 0 1", 3.1, 2.0),
            ("pitch", "shoulder", "upper", "0.11", "0 1 0", 2.0, 2.0),
            ("elbow", "upper", "fore", "0.40", "0 1 0", 2.6, 2.0),
            ("forearm_roll", "fore", "roll", "0.20", "0 0 1", 3.1, 2.5),
            ("wrist_pitch", "roll", "wrist", "0.17", "0 1 0", 2.1, 2.5),
            ("tool_roll", "wrist", "tool", "0.10", "0 0 1", 3.1, 3.0)):
        text += _joint(name, parent, child, f"0 0 {height}", axis, (-limit, limit), speed)
    return Urdf("arm6.urdf", text + "</robot>\n")
