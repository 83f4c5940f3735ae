"""A strategy that is watched: what goes wrong in it is told with what to do about it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from covey.model import InputError
from covey.model.units import counted
from covey.model.validation import shown
from covey.simulation import Chase, Fly, Situation
from covey.simulation.information import checked_decision, checked_turns
from covey.simulation.strategy import Policy, description, policy_of

_READ_ONLY = "read-only"
"""Part of NumPy's message when somebody writes to what a situation holds."""


class Watched:
    """A strategy of either side that keeps its decisions, and tells of each fault at once.

    Parameters
    ----------
    role
        "evaders" or "pursuer".
    strategy
        The strategy, or a plain function.
    """

    def __init__(self, role: str, strategy: object) -> None:
        self.decisions: list[object] = []
        self._role, self._strategy = role, strategy
        place = getattr(strategy, "place", None)
        if place is not None:
            self.place = place

    def describe(self) -> Any:
        """Return how the strategy describes itself."""
        return description(self._strategy)

    def start(self, seed: int) -> Policy:
        """Return the policy of one game, watched."""
        policy = self._started(seed)

        def decide(situation: Situation) -> Any:
            decision = self._decided(policy, situation)
            check, advice = _RULES[self._role]
            try:
                check(decision, situation)
            except InputError as error:
                raise InputError(f"{self._role}: {error}; {advice(decision, situation)}") from error
            self.decisions.append(np.array(decision) if self._role == "evaders" else decision)
            return decision

        decide.in_any_frame = getattr(policy, "in_any_frame", False)  # type: ignore[attr-defined]
        return decide

    def _started(self, seed: int) -> Policy:
        try:
            policy = policy_of(self._role, self._strategy, seed)
        except InputError:
            raise
        except Exception as error:  # whatever a strategy of somebody's own raises
            raise InputError(
                f"{self._role}: start(seed) raised {_told(error)}; it is called once for each "
                "game, with a whole number, and returns the policy of that game"
            ) from error
        if not callable(policy):
            raise InputError(
                f"{self._role}: start(seed) returned {shown(policy)}; return a function of a "
                "Situation, which is called at every decision"
            )
        return policy

    def _decided(self, policy: Policy, situation: Situation) -> Any:
        try:
            return policy(situation)
        except Exception as error:  # whatever a strategy of somebody's own raises
            advice = "the traceback above says where"
            if isinstance(error, TypeError) and "argument" in str(error):
                advice = "a policy is called with one argument, a Situation"
            elif _READ_ONLY in str(error):
                advice = "what a situation holds can't be changed; copy the array first"
            raise InputError(
                f"{self._role}: deciding raised {_told(error)}, at time {situation.time:g} with "
                f"{counted(len(situation.evaders), 'evader')} alive; {advice}"
            ) from error


def _told(error: Exception) -> str:
    return f"{type(error).__name__}: {error}"


def _check_turns(decision: object, situation: Situation) -> None:
    checked_turns(decision, len(situation.evaders))


def _check_move(decision: object, situation: Situation) -> None:
    steers = situation.place is not None or situation.chooses_start
    checked_decision(decision, situation, moves=steers)


def _advice_on_turns(decision: Any, situation: Situation) -> str:
    count = len(situation.evaders)
    one_each = hasattr(decision, "__len__") and len(decision) == count
    if not one_each or getattr(decision, "ndim", 1) != 1:
        return (
            f"return one signed turn for each of the {counted(count, 'evader')} alive, in the "
            "order of situation.evaders"
        )
    return "covey.turns_to(situation.team, goal_headings) has the turns to given headings"


def _advice_on_move(decision: Any, situation: Situation) -> str:
    if isinstance(decision, Chase):
        return f"name living evaders, each once: some of {list(situation.evaders)}"
    if isinstance(decision, Fly):
        return f"the speed is at most situation.disk.speed = {situation.disk.speed:g}"
    return "return covey.Chase((i, ...)) to chase evader i, or covey.Fly((vx, vy))"


_RULES: Mapping[str, tuple[Callable[[Any, Situation], None], Callable[[Any, Situation], str]]] = {
    "evaders": (_check_turns, _advice_on_turns),
    "pursuer": (_check_move, _advice_on_move),
}
"""What checks a decision of each side, and says what to do about one that breaks the rules."""
