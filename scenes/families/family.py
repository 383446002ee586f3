"""What a family of scenes is: a function of the number of robots and of a few parameters."""
import dataclasses
import typing

from families.scene import number


class Impossible(ValueError):
    """There is no such scene; the text says why, in one line."""


def require(condition, why):
    if not condition:
        raise Impossible(why)


@dataclasses.dataclass(frozen=True)
class Parameter:
    default: float  # an int for whole numbers, such as seeds
    help: str  # what it is, and its unit


@dataclasses.dataclass(frozen=True)
class Family:
    """name: on the command line. sizes: the numbers of robots there are. file(n): the name of the
    scene of n robots. build(n, **parameters): the Scene."""

    name: str
    sizes: typing.Sequence
    file: typing.Callable
    parameters: dict
    build: typing.Callable

    @property
    def summary(self):
        return self.build.__doc__.split("\n")[0].rstrip(".")

    def sizes_text(self):
        """For people: which numbers of robots there are."""
        if len(self.sizes) == 1:
            return f"{self.sizes[0]}"
        if not isinstance(self.sizes, range):
            return ", ".join(map(str, self.sizes[:-1])) + f" or {self.sizes[-1]}"
        kind = {1: "", 2: "even and "}.get(self.sizes.step, f"a multiple of {self.sizes.step} and ")
        return f"{kind}from {self.sizes[0]} to {self.sizes[-1]}"

    def scene(self, n, **chosen):
        """The name and the Scene of n robots. Throws Impossible.

        A parameter that differs from its default becomes part of the name, so that no scene takes
        another's place.
        """
        require(n in self.sizes, f"no scene of {n} robots; the number must be {self.sizes_text()}")
        values = {name: chosen.get(name, parameter.default)
                  for name, parameter in self.parameters.items()}
        name = self.file(n)
        for key, value in values.items():
            if value != self.parameters[key].default:
                name += f"-{key}{number(value)}"
        return name, self.build(n, **values)


def family(name, sizes, file=None, **parameters):
    """Makes a Family of the function below it. Each parameter: (default, what it is).

    file: as in Family, or a text for str.format; the family's name and two digits unless said.
    """
    template = file or name + "-{n:02d}"

    def decorate(build):
        return Family(name, sizes, template if callable(template) else
                      lambda n: template.format(n=n),
                      {key: Parameter(*value) for key, value in parameters.items()}, build)
    return decorate


def even(least, most):
    return range(least, most + 1, 2)


def families_of(namespace):
    """The families that a module defines, in its order: call with vars()."""
    return [value for value in namespace.values() if isinstance(value, Family)]
