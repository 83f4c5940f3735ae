"""The pursuer of Fig. 4, whose hidden game follows the order of its visible one."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from covey.model import InputError
from covey.model.validation import shown
from covey.players import AssuredPursuer, CommittedPursuer, FixedSequence
from covey.simulation import Outcome

VISIBLE_PURSUERS = ("committed", "assured")


@dataclass(frozen=True)
class AsVisible:
    """While it is visible, one of two pursuers; hidden, it repeats the order of its visible game.

    "The capture sequence taken by the hidden pursuer is set to be the same as that of the visible
    pursuer" (section V.B of the paper): the visible game of the same start and the same settings,
    which is played for this even where the study doesn't ask for it.

    Parameters
    ----------
    margin
        Of the committed pursuer; see `covey.CommittedPursuer`.
    pursuer
        Of the visible game: "committed", as in the paper, or "assured".

    Examples
    --------
    >>> import covey
    >>> from covey import studies
    >>> study = covey.Study(starts=20, pursuer=studies.AsVisible(pursuer="assured"))
    """

    margin: float = 0.01
    pursuer: str = "committed"

    def __post_init__(self) -> None:
        """Check the fields."""
        if self.pursuer not in VISIBLE_PURSUERS:
            choices = " or ".join(f'"{name}"' for name in VISIBLE_PURSUERS)
            raise InputError(f"AsVisible.pursuer: expected {choices}, got {shown(self.pursuer)}")
        self.visible()

    def visible(self) -> CommittedPursuer | AssuredPursuer:
        """Return the pursuer of the visible game."""
        return CommittedPursuer(self.margin) if self.pursuer == "committed" else AssuredPursuer()

    def hidden(self, visible: Outcome, count: int) -> FixedSequence:
        """Return the pursuer of the hidden game.

        Evaders that the visible one had not captured when it was stopped come last, by number.
        """
        captured = visible.capture_sequence.tolist()
        rest = [i for i in range(count) if i not in captured]
        return FixedSequence([*captured, *rest])

    def describe(self) -> Mapping[str, Any]:
        """Return name and parameters, as a study file gives them."""
        return {"name": "as-visible", "margin": self.margin, "pursuer": self.pursuer}
