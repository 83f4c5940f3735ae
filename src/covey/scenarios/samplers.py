"""Where evaders start: samplers, each a value that draws one start after another.

The pursuer's disk is centred at the origin. A sampler gets the random stream of one start and
nothing else, so a start doesn't depend on which others are drawn, in what order, or by whom.
"""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass
from typing import Any, Protocol

import numpy as np

from covey.model.angles import away_from, unit_vectors
from covey.model.validation import Floats, choice, number

HEADINGS = ("away", "random")
SHAPES = ("line", "wedge", "ring")


class Sampler(Protocol):
    """Draws starts."""

    def draw(self, start: int, count: int, generator: np.random.Generator) -> tuple[Floats, Floats]:
        """Return positions (count, 2) and headings (count,), radians, of start number `start`."""
        ...

    def describe(self) -> dict[str, Any]:
        """Return name and parameters, as a study file gives them."""
        ...


@dataclass(frozen=True)
class Square:
    """Uniform in a square, as in section V.B of the paper.

    A team of three is the first three of a team of five: teams of all sizes meet the same starts.

    Parameters
    ----------
    side
        Of the square around the pursuer, a length > 0.
    headings
        "away" from the pursuer, or "random".

    Examples
    --------
    >>> import covey
    >>> from covey import studies
    >>> study = covey.Study(sampler=studies.Square(side=2.0, headings="random"))
    """

    side: float = 1.0
    headings: str = "away"

    def __post_init__(self) -> None:
        """Check the fields."""
        number("Square.side", self.side, low=0.0, strictly=True)
        choice("Square.headings", self.headings, HEADINGS)

    def draw(self, start: int, count: int, generator: np.random.Generator) -> tuple[Floats, Floats]:  # noqa: ARG002 the protocol
        """Return positions and headings."""
        angles, points = generator.spawn(2)
        positions = points.uniform(-0.5 * self.side, 0.5 * self.side, (count, 2))
        return positions, _headings(self.headings, positions, angles)

    def describe(self) -> dict[str, Any]:
        """Return name and parameters."""
        return {"name": "square", **asdict(self)}


@dataclass(frozen=True)
class Disk:
    """Uniform in a disk around the pursuer.

    Parameters
    ----------
    radius
        A length > 0.
    headings
        "away" from the pursuer, or "random".

    Examples
    --------
    >>> import covey
    >>> from covey import studies
    >>> study = covey.Study(sampler=studies.Disk(radius=0.5))
    """

    radius: float = 0.5
    headings: str = "away"

    def __post_init__(self) -> None:
        """Check the fields."""
        number("Disk.radius", self.radius, low=0.0, strictly=True)
        choice("Disk.headings", self.headings, HEADINGS)

    def draw(self, start: int, count: int, generator: np.random.Generator) -> tuple[Floats, Floats]:  # noqa: ARG002 the protocol
        """Return positions and headings."""
        angles, points = generator.spawn(2)
        shares, bearings = points.uniform(0.0, 1.0, (count, 2)).T
        # The root makes rings of equal area equally likely.
        distances = self.radius * np.sqrt(shares)
        turns = math.tau * bearings
        positions = distances[:, None] * unit_vectors(turns)
        return positions, _headings(self.headings, positions, angles)

    def describe(self) -> dict[str, Any]:
        """Return name and parameters."""
        return {"name": "disk", **asdict(self)}


@dataclass(frozen=True)
class Formation:
    """A formation that flies in a random direction, at a random bearing from the pursuer.

    Parameters
    ----------
    shape
        "line" abreast, "wedge" with the first evader at its tip, or "ring".
    spacing
        Between neighbours, a length > 0.
    distance
        From the pursuer to the middle of the formation, a length >= 0.

    Examples
    --------
    >>> import covey
    >>> from covey import studies
    >>> study = covey.Study(sampler=studies.Formation(shape="wedge", spacing=0.1, distance=0.5))
    """

    shape: str = "wedge"
    spacing: float = 0.1
    distance: float = 0.5

    def __post_init__(self) -> None:
        """Check the fields."""
        choice("Formation.shape", self.shape, SHAPES)
        number("Formation.spacing", self.spacing, low=0.0, strictly=True)
        number("Formation.distance", self.distance, low=0.0)

    def draw(self, start: int, count: int, generator: np.random.Generator) -> tuple[Floats, Floats]:  # noqa: ARG002 the protocol
        """Return positions and headings."""
        bearing, heading = generator.uniform(-math.pi, math.pi, 2)
        slots = self.spacing * _slots(self.shape, count)
        slots -= slots.mean(axis=0)
        along = unit_vectors(heading)
        across = np.array([-along[1], along[0]])
        middle = self.distance * unit_vectors(bearing)
        positions = middle + slots[:, :1] * along + slots[:, 1:] * across
        return positions, np.full(count, heading)

    def describe(self) -> dict[str, Any]:
        """Return name and parameters."""
        return {"name": "formation", **asdict(self)}


def _headings(how: str, positions: Floats, generator: np.random.Generator) -> Floats:
    if how == "away":
        return away_from((0.0, 0.0), positions)
    return generator.uniform(-math.pi, math.pi, len(positions))


def _slots(shape: str, count: int) -> Floats:
    """Places (count, 2) along and across the flight, neighbours 1 apart."""
    rank = np.arange(count, dtype=np.float64)
    if shape == "line":
        return np.column_stack([np.zeros(count), rank])
    if shape == "wedge":
        row, side = np.ceil(rank / 2.0), np.where(rank % 2.0 == 1.0, 1.0, -1.0)
        return math.sqrt(0.5) * np.column_stack([-row, side * row])
    radius = 0.5 / math.sin(math.pi / count) if count > 1 else 0.0
    angles = math.tau * rank / count
    return radius * unit_vectors(angles)
