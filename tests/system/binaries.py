"""Where the programs are that tests run."""

import os
import pathlib

ROOT = pathlib.Path(__file__).resolve().parents[2]


def binary(variable, place):
    """What the environment names, else what the build folder has at that place. It is taken out of the
    environment, since processes would take it for a setting."""
    return os.environ.pop(variable, str(ROOT / "build" / place))
