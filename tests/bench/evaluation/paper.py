"""What the ARC paper published: the numbers that its text and its one table give.

Source: Solis, Motes, Qin, Morales, Amato, "Adaptive Robot Coordination: A Subproblem-based
Approach for Hybrid Multi-Robot Motion Planning", 2023, section V ("Experiments"): 33 trials of at
most 1000 s each. Its plots are pictures whose values the text does not give; where there is no
number, there is None here, and what the text says instead. The paper names neither its machine
nor the measures of its scenes: ours are modelled on its figures.
"""
import dataclasses

TRIALS, TIME_LIMIT = 33, 1000


@dataclasses.dataclass(frozen=True)
class Result:
    family: str
    robots: int  # None: said of all sizes
    method: str
    success: float  # share of the trials; None: not given
    says: str = ""  # in the paper's words
    time: tuple = None  # s: mean and standard deviation
    cost: tuple = None  # timesteps: mean and standard deviation


_UNFIT = "fails due to coordination deficiencies or incapacity to scale"

RESULTS = (
    Result("low-mobile", 32, "arc", 1.0, "one of the only two to solve all trials for 32 robots"),
    Result("low-mobile", 32, "decoupled-prm", 1.0,
           "one of the only two to solve all trials for 32 robots"),
    Result("low-mobile", 8, "composite-prm", 1.0),
    Result("low-mobile", 16, "composite-prm", 0.24),
    Result("low-mobile", 8, "cbs-mp", 1.0),
    Result("low-mobile", 16, "cbs-mp", 0.36),
    Result("low-manipulator", None, "arc", None,
           "best planning times, with CBS-MP; slightly more expensive solutions"),
    Result("low-manipulator", None, "decoupled-prm", 1.0, "all trials, but at a slower pace"),
    Result("low-manipulator", 8, "composite-prm", 0.27),
    Result("low-manipulator", None, "cbs-mp", None, "best planning times, with ARC; better costs"),
    Result("high-mobile", 2, "arc", 1.0, "better cost than Composite PRM"),
    Result("high-mobile", 2, "decoupled-prm", None, "failed to solve all the trials"),
    Result("high-mobile", 2, "composite-prm", 1.0),
    Result("high-mobile", 2, "cbs-mp", 0.66),
    Result("high-manipulator", None, "arc", 1.0, "slightly higher planning times"),
    Result("high-manipulator", None, "decoupled-prm", None,
           "fails due to its inherent lack of coordination"),
    Result("high-manipulator", None, "composite-prm", 1.0, "comparable to ARC in time and cost"),
    Result("high-manipulator", None, "cbs-mp", None, "falls short as it exhausts time"),
    Result("adaptive-mobile", 16, "arc", 1.0, "", (24.5, 20.5), (450.1, 19.6)),
    Result("adaptive-mobile", 16, "decoupled-prm", 0.0, _UNFIT),
    Result("adaptive-mobile", 16, "composite-prm", 0.0, _UNFIT),
    Result("adaptive-mobile", 16, "cbs-mp", 0.0, _UNFIT),
    Result("adaptive-manipulator", 8, "arc", 1.0, "", (9.4, 6.1), (316.5, 121.5)),
    Result("adaptive-manipulator", 8, "decoupled-prm", 0.0, _UNFIT),
    Result("adaptive-manipulator", 8, "composite-prm", 0.0, _UNFIT),
    Result("adaptive-manipulator", 8, "cbs-mp", 0.0, _UNFIT),
)


def of(group):
    """What the paper says of a summary.Group, or None."""
    return next((result for result in RESULTS if result.family == group.family
                 and result.method == group.method and result.robots in (None, group.robots)), None)
