"""The exact minimum of the last capture for large teams, between two bounds that close.

Lower bounds are least walks, which improve with the weights of visits and with what walks remember.
Upper bounds are sequences. The exact programme is tried as soon as few labels may be left, with as
many labels as states were extended before, so that it costs no more than the bounds did.
"""

from __future__ import annotations

import math

from covey.kernels._jit import compiled, inlined
from covey.kernels.arrays import (
    LABELS_TAKEN,
    MOST_NEIGHBOURS,
    SOLVED,
    STAGES_GIVEN,
    STATES_TAKEN,
    Floats,
    Ints,
    WalkMemory,
    padded,
)
from covey.kernels.capture.interception import capture_in_turn
from covey.kernels.capture.path import TURN_END
from covey.kernels.capture.pursuit import Pursuit, initial_disk
from covey.kernels.capture.straight_legs import captures_on_lines, set_lines
from covey.kernels.minimum.greedy_sequence import greedy_sequence
from covey.kernels.minimum.large.completions import set_completions
from covey.kernels.minimum.large.neighbours import (
    grow_along,
    memory_bits,
    set_nearest,
    set_transitions,
)
from covey.kernels.minimum.large.scratch import (
    LOWER,
    STATES,
    UPPER,
    LargeScratch,
    is_to_end,
    large_scratch,
)
from covey.kernels.minimum.large.search import FAILED, search_labels
from covey.kernels.minimum.large.tours import Tour, improve, repair
from covey.kernels.minimum.large.walks import least_walk, trace_walk
from covey.kernels.minimum.large.weights import count_visits, set_weights, step_shares

FIRST_ROUNDS = 6
"""Steps of the weights before the exact programme is tried; twice as many before it is tried again.
"""

_MANY_LABELS, _MORE_LABELS, _ROUNDS_AGAIN = 2, 8, 3  # labels over the states of a least walk
_KNOWN_LABELS, _FEWEST_LABELS = 4, 1 << 12
_WORTH_IMPROVING = 1.1  # sequences up to so many times the best sequence are improved by moves
_PATIENCE, _SHORTER = 4, 0.6  # steps without a better bound, after which steps are shorter
_ROUNDING = 1e-14


@compiled
def large_minimum(
    paths: Floats,
    pursuit: Pursuit,
    bound: float,
    sequence: Ints,
    memory: WalkMemory,
    lines: Floats,
    stop: Ints,
) -> tuple[float, int, bool]:
    """Return the least time of a capture sequence that is found, if it is below `bound`.

    `memory.floats[LOWER]` is then a time that no sequence beats. Where it is the returned time, or
    no less than the bound, the result is exact.

    1. Without a bound, a greedy sequence is improved by moves.
    2. With the weights of the call before, the exact programme is tried at once.
    3. Rounds of least walks: each is a lower bound, may become a better sequence, and changes the
       weights. After 6, 12, 24, ... rounds the exact programme is tried. From the second stage on
       neighbours are added where walks repeat.

    Parameters
    ----------
    paths
        (n, PATH).
    pursuit
        The pursuer.
    bound
        inf, or an upper bound.
    sequence
        (n,) modified in place where a sequence beats the bound.
    memory
        With room for n evaders; modified in place. Weights and neighbours are kept from call to
        call.
    lines
        (6, padded(n)) or more columns, modified in place.
    stop
        (1,) of the workspace.

    Returns
    -------
    float
        The least time found, or `bound`.
    int
        How many interceptions were computed, about.
    bool
        Whether the result is exact.
    """
    n = len(paths)
    scratch = large_scratch(memory, lines, stop, n)
    _begin(paths, pursuit, bound, scratch)
    solved = _is_known(n, scratch) and _search_again(paths, pursuit, scratch)
    if not solved:
        _solve(paths, pursuit, scratch)
    upper = scratch.known[UPPER]
    if upper < bound:
        for k in range(n):
            sequence[k] = scratch.sequence[k]
    proven = scratch.known[LOWER] >= upper
    return min(upper, bound), int(scratch.known[STATES]) * n, proven


@inlined
def _begin(paths: Floats, pursuit: Pursuit, bound: float, scratch: LargeScratch) -> None:
    """Write the first captures and the first upper bound."""
    n, first, disk = len(paths), scratch.first, initial_disk(pursuit)
    set_lines(paths, scratch.lines)
    captures_on_lines(scratch.lines, disk, first[: padded(n)])
    for i in range(n):
        if first[i] < paths[i, TURN_END]:
            first[i] = capture_in_turn(paths, i, disk)
    if bound == math.inf:
        tour = Tour(scratch.sequence[:n], scratch.capture_times[:n], scratch.trial[:n])
        greedy_sequence(paths, pursuit, tour.sequence, tour.times)
        bound = improve(paths, pursuit, tour)
    scratch.known[LOWER], scratch.known[UPPER], scratch.known[STATES] = 0.0, bound, 0.0


@inlined
def _is_known(n: int, scratch: LargeScratch) -> bool:
    """Whether the weights and neighbours are those of a call for as many evaders."""
    return scratch.kept[SOLVED] == n


@inlined
def _search_again(paths: Floats, pursuit: Pursuit, scratch: LargeScratch) -> bool:
    """Try the exact programme with weights and neighbours almost as they are.

    Where it took many labels the last time, a few least walks improve the weights first.
    """
    n, kept = len(paths), scratch.kept
    if kept[LABELS_TAKEN] > _MANY_LABELS * kept[STATES_TAKEN]:
        most = memory_bits(n, scratch.neighbours)
        if kept[LABELS_TAKEN] > _MORE_LABELS * kept[STATES_TAKEN]:
            most = min(most + 1, MOST_NEIGHBOURS)
        if _walk_rounds(paths, pursuit, _ROUNDS_AGAIN, most, scratch):
            return True
    bits = memory_bits(n, scratch.neighbours)
    weight = set_weights(scratch.shares[:n], scratch.weights)
    budget = max(_FEWEST_LABELS, _KNOWN_LABELS * kept[LABELS_TAKEN])
    return _search(paths, pursuit, weight, bits, budget, scratch)


@compiled
def _search(
    paths: Floats, pursuit: Pursuit, weight: int, bits: int, budget: int, scratch: LargeScratch
) -> bool:
    """Try the exact programme; return whether the bounds are closed."""
    before = scratch.known[STATES]
    set_completions(paths, pursuit, weight, bits, scratch)
    walked = scratch.known[STATES]
    least = search_labels(paths, pursuit, weight, bits, budget, scratch)
    if least == FAILED:
        scratch.known[STATES] = before
        return False
    scratch.kept[LABELS_TAKEN] = int(scratch.known[STATES] - walked)
    scratch.known[LOWER] = scratch.known[UPPER] = least
    return True


@inlined
def _solve(paths: Floats, pursuit: Pursuit, scratch: LargeScratch) -> None:
    """Close the bounds, stage by stage, as far as the stages go."""
    n, kept = len(paths), scratch.kept
    known = _is_known(n, scratch)
    if not known:
        kept[SOLVED], kept[LABELS_TAKEN], kept[STATES_TAKEN] = n, 0, 0
        set_nearest(paths, scratch.known[UPPER], scratch.neighbours)
        for i in range(n):
            scratch.shares[i] = 1.0
    rounds, bits = FIRST_ROUNDS, memory_bits(n, scratch.neighbours)
    most = min(bits + known, MOST_NEIGHBOURS)
    set_transitions(n, bits, scratch.neighbours, scratch.bits, scratch.transitions)
    for _ in range(kept[STAGES_GIVEN]):
        if _walk_rounds(paths, pursuit, rounds, most, scratch):
            return
        bits = memory_bits(n, scratch.neighbours)
        weight = set_weights(scratch.shares[:n], scratch.weights)
        budget = int(scratch.known[STATES])
        if is_to_end(scratch) or _search(paths, pursuit, weight, bits, budget, scratch):
            return
        rounds, most = 2 * rounds, min(most + 1, MOST_NEIGHBOURS)


@compiled
def _walk_rounds(
    paths: Floats, pursuit: Pursuit, rounds: int, most: int, scratch: LargeScratch
) -> bool:
    """Improve both bounds by so many least walks; return whether the bounds are closed.

    The shares are then those of the best lower bound of these rounds.
    """
    n, known = len(paths), scratch.known
    length_of_step, failures, best = 1.0, 0, -1.0
    for i in range(n):
        scratch.direction[i] = 0.0
    for step in range(rounds):
        if step > 0 and is_to_end(scratch):
            break
        bits = memory_bits(n, scratch.neighbours)
        weight = set_weights(scratch.shares[:n], scratch.weights)
        before = known[STATES]
        lower, end = least_walk(paths, pursuit, weight, bits, scratch)
        scratch.kept[STATES_TAKEN] = int(known[STATES] - before)
        if end < 0:
            known[LOWER] = known[UPPER]
            return True
        known[LOWER] = max(known[LOWER], lower)
        length = trace_walk(n, weight, bits, end, scratch.weights, scratch.steps, scratch.walk)
        walk = scratch.walk[:length]
        is_sequence = count_visits(n, walk, scratch.visits)
        if lower > best or is_sequence:
            best, failures = lower, 0
            for i in range(n):
                scratch.best_shares[i] = scratch.shares[i]
            _improve_upper(paths, pursuit, walk, scratch)
        else:
            failures += 1
            if failures == _PATIENCE:
                failures, length_of_step = 0, _SHORTER * length_of_step
        if is_sequence or known[LOWER] >= known[UPPER] * (1.0 - _ROUNDING):
            known[LOWER] = known[UPPER]
            return True
        _grow(n, walk, most, scratch)
        step_shares(n, length_of_step * (1.0 - lower / known[UPPER]), scratch)
    for i in range(n):
        scratch.shares[i] = scratch.best_shares[i]
    return False


@inlined
def _grow(n: int, walk: Ints, most: int, scratch: LargeScratch) -> None:
    """Let evaders remember whom the walk repeats, see `grow_along`."""
    if grow_along(walk, most, scratch.neighbours):
        bits = memory_bits(n, scratch.neighbours)
        set_transitions(n, bits, scratch.neighbours, scratch.bits, scratch.transitions)


@inlined
def _improve_upper(paths: Floats, pursuit: Pursuit, walk: Ints, scratch: LargeScratch) -> None:
    """Lower the upper bound by the sequence that a walk becomes, if this is better."""
    n, known = len(paths), scratch.known
    tour = Tour(scratch.candidate[:n], scratch.capture_times[:n], scratch.trial[:n])
    time = repair(paths, pursuit, walk, tour)
    if time < _WORTH_IMPROVING * known[UPPER]:
        time = improve(paths, pursuit, tour)
    if time < known[UPPER]:
        known[UPPER] = time
        for k in range(n):
            scratch.sequence[k] = tour.sequence[k]
