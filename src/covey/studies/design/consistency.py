"""What must fit together in a study, beyond the single values."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import product
from typing import Any

from covey.model import InputError
from covey.model.objectives import distribution_of
from covey.model.units import counted
from covey.model.validation import is_slower
from covey.planning.compiled_objective import checked_objective, compiled_objective
from covey.players import FixedSequence, KnownSequence, RandomSequence
from covey.scenarios.consistency import not_both, too_fast
from covey.scenarios.mistakes import KeyPath, Mistake
from covey.studies.design.start_table import FromFile


def inconsistencies(values: Mapping[str, Any]) -> Iterator[Mistake]:
    """Find what doesn't fit together among the values of all fields, each right by itself."""
    if values["turn_rate"] is not None and values["turn_radius"] is not None:
        yield not_both("turn_rate", ("grid", "turn_radius"))
    fastest, slowest = max(values["speed"]), min(values["pursuer_speed"])
    if not is_slower(fastest, slowest):
        yield too_fast(("grid", "speed"), fastest, slowest)
    yield from _sequences(values)
    yield from _objectives(values)
    yield from _files(values)


def _sequences(values: Mapping[str, Any]) -> Iterator[Mistake]:
    for side, size in product(("pursuer", "evaders"), values["team_size"]):
        for index, strategy in enumerate(values[side]):
            known = isinstance(strategy, FixedSequence | KnownSequence)
            if known and strategy.sequence is not None and len(strategy.sequence) != size:
                text = (
                    f"expected a sequence of all {counted(size, 'evader')} of a team, got "
                    f"{list(strategy.sequence)}; a study of several team sizes has no common one"
                )
                yield Mistake(("grid", side, index, "sequence"), text)
            if isinstance(strategy, RandomSequence) and strategy.sequences is not None:
                yield from _draws(("grid", side, index), strategy, size)


def _draws(path: KeyPath, strategy: RandomSequence, size: int) -> Iterator[Mistake]:
    try:
        distribution_of("RandomSequence", strategy.sequences, strategy.weights, size)
    except InputError as error:
        yield Mistake(path, str(error))


def _objectives(values: Mapping[str, Any]) -> Iterator[Mistake]:
    for (index, objective), size in product(enumerate(values["objective"]), values["team_size"]):
        try:
            compiled_objective(checked_objective(objective), size)
        except InputError as error:
            yield Mistake(("grid", "objective", index), str(error))


def _files(values: Mapping[str, Any]) -> Iterator[Mistake]:
    sampler = values["sampler"]
    if not isinstance(sampler, FromFile):
        return
    if len(sampler.all) < values["starts"]:
        text = f"expected at most {len(sampler.all)}, as many as {sampler.path} has"
        yield Mistake(("starts",), f"{text}, got {values['starts']}")
    largest = max(values["team_size"])
    if sampler.all.smallest_team < largest:
        text = f"expected at most {sampler.all.smallest_team}, the evaders of the smallest start in"
        yield Mistake(("grid", "team_size"), f"{text} {sampler.path}, got {largest}")
