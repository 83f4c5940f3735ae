"""When a pursuer on a straight line first comes near an evader: against dense sampling."""

from __future__ import annotations

import math

import numpy as np
import pytest

from covey.kernels.capture.path import PATH, set_paths
from covey.kernels.play.first_contact import Flight, first_contact
from soak.reference_flight import fly

SAMPLES = 2000
HALVINGS = 60
TOUCH = 1e-11
"""A length, in passes of about unit size: how exactly a distance can be told to be the reach."""
MOMENT = 1e-9
"""A time, in passes of about unit length: how much later than by bisection a contact may come."""


class Pass:
    """An evader (x, y, heading, speed, turn rate) on its path, and a pursuer that flies past it."""

    def __init__(self, evader, turn, place, velocity, reach, latest):
        self.evader, self.turn = np.array(evader, dtype=float), float(turn)
        self.place, self.velocity = np.array(place, dtype=float), np.array(velocity, dtype=float)
        self.reach, self.latest = float(reach), float(latest)

    def gap(self, times):
        """Distance less the reach at `times` (T,)."""
        x, y, heading, speed, turn_rate = self.evader
        evader, _ = fly((x, y), heading, speed, turn_rate, self.turn, times)
        off = evader - self.place - np.outer(times, self.velocity)
        return np.hypot(off[:, 0], off[:, 1]) - self.reach

    def found(self):
        """What the kernel says."""
        paths = np.empty((1, PATH))
        set_paths(self.evader[None], np.array([self.turn]), 1.0, paths)
        flight = Flight(*self.place, *self.velocity, self.reach)
        return first_contact(paths, 0, flight, self.latest)

    def sampled(self):
        """The first sample within reach, made exact by bisection; inf where there is none."""
        times = np.linspace(0.0, self.latest, SAMPLES + 1)
        within = self.gap(times) <= 0.0
        if not within.any():
            return math.inf
        first = int(within.argmax())
        if first == 0:
            return 0.0
        outside, inside = times[first - 1 : first + 1]
        for _ in range(HALVINGS):
            middle = 0.5 * (outside + inside)
            if self.gap(np.array([middle]))[0] <= 0.0:
                inside = middle
            else:
                outside = middle
        return inside

    def closest(self):
        """The least gap, to the last digits: the samples, then finer ones about the least."""
        low, high = 0.0, self.latest
        while high - low > 1e-9 * self.latest:
            times = np.linspace(low, high, SAMPLES + 1)
            least = int(self.gap(times).argmin())
            low, high = times[max(least - 1, 0)], times[min(least + 1, SAMPLES)]
        return float(self.gap(np.array([0.5 * (low + high)]))[0])


def random_pass(generator):
    """The pursuer stands, or makes more or less for where the evader starts."""
    place, evader = generator.uniform(-0.5, 0.5, (2, 2))
    course = math.atan2(*(evader - place)[::-1]) + generator.uniform(-1.0, 1.0)
    speed = generator.choice([0.0, 0.4, 1.0])
    return Pass(
        evader=[
            *evader,
            generator.uniform(-math.pi, math.pi),
            generator.choice([0.0, 0.1, 0.3, 0.8]),
            generator.choice([0.0, 0.3, math.pi / 2, 6.0, 30.0, math.inf]),
        ],
        turn=generator.uniform(-math.pi, math.pi),
        place=place,
        velocity=(speed * math.cos(course), speed * math.sin(course)),
        reach=10.0 ** generator.uniform(-2.0, -0.3),
        latest=generator.choice([0.2, 1.0, 4.0]),
    )


@pytest.mark.parametrize("batch", range(4))
def test_it_is_the_first_contact_and_none_is_missed(batch):
    kinds = {"at once": 0, "later": 0, "never": 0}
    for seed in range(250):
        flown_past = random_pass(np.random.default_rng([batch, seed]))
        found = flown_past.found()
        if math.isinf(found):
            kinds["never"] += 1
            assert flown_past.closest() >= -TOUCH
        elif found == 0.0:
            kinds["at once"] += 1
            assert flown_past.gap(np.zeros(1))[0] <= TOUCH
        else:
            kinds["later"] += 1
            assert abs(flown_past.gap(np.array([found]))[0]) <= TOUCH
            assert found <= min(flown_past.sampled() + MOMENT, flown_past.latest)
    assert min(kinds.values()) >= 8


@pytest.mark.parametrize("by", [1e-3, 1e-6, 1e-9])
def test_a_grazing_pass_counts_if_it_touches(by):
    """The same pass with a reach a little larger, and a little smaller, than the least distance."""
    grazing = 0
    for seed in range(150):
        flown_past = random_pass(np.random.default_rng(seed))
        least = flown_past.closest()
        distances = flown_past.gap(np.array([0.0, flown_past.latest])) - least
        if distances.min() < 0.01 or flown_past.reach + least < 0.01:
            continue  # nearest at the beginning or at the end, or right through the evader
        grazing += 1
        flown_past.reach += least + by
        touched = flown_past.found()
        assert touched < flown_past.latest
        assert abs(flown_past.gap(np.array([touched]))[0]) <= TOUCH
        flown_past.reach -= 2.0 * by
        assert math.isinf(flown_past.found())
    assert grazing >= 20


def on_unit_circle(turn, reach, latest, turning_about=(0.0, 0.0)):
    """An evader that starts at (1, 0) of a unit circle; a pursuer that stands at its centre."""
    x, y = turning_about
    return Pass([x + 1.0, y, math.pi / 2, 1.0, 1.0], turn, turning_about, (0.0, 0.0), reach, latest)


@pytest.mark.parametrize("short", [1e-2, 1e-4, 1e-6, 1e-8])
def test_a_pursuer_at_the_centre_of_a_turn_never_quite_reaches_it(short):
    """The distance stays the same for the whole turn: no step may jump to a conclusion."""
    assert math.isinf(on_unit_circle(math.pi, 1.0 - short, 3.0).found())


def test_a_pursuer_at_the_centre_of_a_turn_that_reaches_it_does_so_at_once():
    assert on_unit_circle(math.pi, 1.0 + 1e-9, 3.0).found() == 0.0


def test_one_that_is_in_reach_already_is_touched_at_once():
    assert Pass([0.1, 0.0, 0.0, 0.5, 1.0], 1.0, (0.0, 0.0), (-1.0, 0.0), 0.2, 1.0).found() == 0.0


def test_head_on():
    """They close at the sum of their speeds."""
    found = Pass([1.0, 0.0, math.pi, 0.25, 0.0], 0.0, (0.0, 0.0), (0.5, 0.0), 0.1, 2.0).found()
    assert found == pytest.approx(0.9 / 0.75, abs=TOUCH)


def test_what_comes_too_late_is_no_contact():
    evader = [1.0, 0.0, math.pi, 0.25, 0.0]
    meeting = 0.9 / 0.75
    for latest, touched in [(meeting - 1e-6, False), (meeting + 1e-6, True)]:
        found = Pass(evader, 0.0, (0.0, 0.0), (0.5, 0.0), 0.1, latest).found()
        assert math.isfinite(found) is touched


def test_one_that_flies_away_is_never_touched():
    assert math.isinf(
        Pass([0.3, 0.0, 0.0, 0.5, 1.0], 0.0, (0.0, 0.0), (0.4, 0.0), 0.1, 1e6).found()
    )
