"""What is promised by plans that answer captures, and by a team that flies them."""

from __future__ import annotations

import covey
from covey.players import survival
from covey.players.teams.replan_interval import at_interval
from covey.simulation.strategy import in_any_frame
from soak.errors import difference, exactly, largest_fall, shortfall

LARGEST = 4
"""Evaders up to which plans of every depth are made; five answer one capture."""


def promises(case, game):
    """The first promise with delays is kept; with prompt captures the promise never falls.

    A capture is prompt if it happens as early as the plan must fear. Those of a hidden pursuer that
    keeps to one order are.
    """
    strategy = case.evaders.strategy
    first = covey.plan_contingent(case.team, case.disk, strategy.depth, seed=case.seed)
    promised = first.with_delays.survival_time
    found = {"promise with delays is kept": shortfall(promised, game.survival_time)}
    if case.sensing == "hidden" and case.pursuer.ends:
        until = []
        team, settings = Noting(strategy, until), case.settings()
        again = survival(
            case.team, case.disk, evaders=team, pursuer=case.pursuer.strategy, **settings
        )
        found["the noted game is the same"] = difference(again.survival_time, game.survival_time)
        found["promises of answers never fall"] = largest_fall(until) / (max(until) or 1.0)
    return found


class Noting:
    """A team that answers captures, and notes until when each of its plans promises survival."""

    def __init__(self, strategy, until):
        self._strategy, self._until = strategy, until

    def start(self, seed):
        """Return the policy of one game."""
        planner = self._strategy.planner(seed)

        def noted(situation):
            turns = planner(situation)
            self._until.append(situation.time + planner.promise)
            return turns

        return in_any_frame(at_interval(noted, self._strategy.replan_time))


def plans(case, game):
    """Depth 0 is the open-loop plan, no depth promises less, and none exceeds the upper end."""
    n = len(case.team)
    if n > LARGEST + 1:
        return {}
    depths = range(n) if n <= LARGEST else range(2)
    trees = [covey.plan_contingent(case.team, case.disk, k, seed=case.seed) for k in depths]
    plan = covey.plan(case.team, case.disk, seed=case.seed)
    times = [tree.survival_time for tree in trees]
    upper = covey.bracket(case.team, case.disk, seed=case.seed).upper
    same = plan.turns.tolist() == trees[0].turns.tolist() and plan.survival_time == times[0]
    delayed = max(tree.with_delays.survival_time - tree.survival_time for tree in trees)
    return {
        "depth 0 is the open-loop plan": exactly(same),
        "a deeper plan never promises less": largest_fall(times) / (max(times) or 1.0),
        "no more with delays": exactly(delayed <= 0.0),
        "answers below the upper end": shortfall(max(times), upper),
    }
