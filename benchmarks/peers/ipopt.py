"""CasADi and IPOPT on eq. (6) in epigraph form, the capture times variables beside the turns.

A capture time is the root of eq. (7), which has no closed form while the evader turns. So each is a
variable, and its equation a constraint; sequences that begin alike share what they begin with. Of
the forms that were tried this one was the fastest: distances squared took 1.3 times as long, times
eliminated by closed form and unrolled Newton steps 3 to 4 times. IPOPT gets exact first and second
derivatives, sparse. The programme is built once for a team size, which is not timed.
"""

from __future__ import annotations

import math

import casadi as ca
import numpy as np

from peers.enumeration import Sequences, capture_times
from peers.peer import Peer

TOLERANCE = 1e-8
"""IPOPT's, on its scaled optimality conditions: survival times agree to 1e-9 with the planner's."""

_OPTIONS = {
    "print_time": False,
    "ipopt.print_level": 0,
    "ipopt.sb": "yes",
    "ipopt.tol": TOLERANCE,
    "ipopt.max_iter": 500,
}
_WARM_OPTIONS = _OPTIONS | {
    "ipopt.warm_start_init_point": "yes",
    "ipopt.warm_start_bound_push": 1e-9,
    "ipopt.warm_start_bound_frac": 1e-9,
    "ipopt.warm_start_slack_bound_push": 1e-9,
    "ipopt.warm_start_slack_bound_frac": 1e-9,
    "ipopt.warm_start_mult_bound_push": 1e-9,
    "ipopt.mu_init": 1e-6,
}


class Ipopt(Peer):
    """The interior-point method, from turns alone or with the multipliers of a moment ago."""

    name = "CasADi and IPOPT"
    largest = 6

    def __init__(self, count):
        self.sequences = Sequences(count)
        programme, equations = _programme(self.sequences)
        turns_and_others = [count, programme["x"].numel() - count]
        equal_and_more = [equations, programme["g"].numel() - equations]
        self.limits = {
            "lbx": np.repeat([-math.pi, 0.0], turns_and_others),
            "ubx": np.repeat([math.pi, math.inf], turns_and_others),
            "lbg": 0.0,
            "ubg": np.repeat([0.0, math.inf], equal_and_more),
        }
        self.from_turns = ca.nlpsol("cold", "ipopt", programme, _OPTIONS)
        self.from_multipliers = ca.nlpsol("warm", "ipopt", programme, _WARM_OPTIONS)

    def solve(self, team, disk, turns, memory):
        """Return the turns of a local maximum, from `turns`, and the multipliers there."""
        times = capture_times(self.sequences, team, disk, turns)
        answer = (self.from_multipliers if memory else self.from_turns)(
            x0=np.concatenate([turns, [times[-1].min()], *times]),
            p=_numbers(team, disk),
            **self.limits,
            **(memory or {}),
        )
        found = np.array(answer["x"]).ravel()[: len(turns)]
        multipliers = {"lam_x0": answer["lam_x"], "lam_g0": answer["lam_g"]}
        return np.clip(found, -math.pi, math.pi), multipliers


def _numbers(team, disk):
    """The game as the programme's parameters."""
    rows = [team.positions, team.headings, team.speeds, team.turn_rates]
    radii = [disk.radius + disk.capture_radius, 2.0 * disk.capture_radius]
    return ca.veccat(*rows, disk.center, radii, disk.speed)


def _programme(sequences):
    """Maximise z subject to z <= f_s; return it, and how many of its constraints are equations."""
    n = sequences.count
    starts, center = ca.SX.sym("x", n, 2), ca.SX.sym("c", 1, 2)
    headings, speeds, rates = (ca.SX.sym(name, n) for name in ("θ", "v", "ω"))
    radii, pursuer_speed = ca.SX.sym("r", 2), ca.SX.sym("v_p")
    turns, value = ca.SX.sym("δ", n), ca.SX.sym("z")

    def place(i, time):
        """The chord of the arc flown until then, and what is flown straight (eq. 5)."""
        turning = ca.fmin(time, ca.fabs(turns[i]) / rates[i])
        half, goal = 0.5 * ca.sign(turns[i]) * rates[i] * turning, headings[i] + turns[i]
        chord = 2.0 * speeds[i] / rates[i] * ca.sin(ca.fabs(half))
        straight = speeds[i] * (time - turning)
        return starts[i, :] + ca.horzcat(
            chord * ca.cos(headings[i] + half) + straight * ca.cos(goal),
            chord * ca.sin(headings[i] + half) + straight * ca.sin(goal),
        )

    variables, equations = [], []
    places, times, radius = [center], [ca.SX(0.0)], radii[0]
    for parents, evaders in zip(sequences.parents, sequences.evaders, strict=True):
        before, start = [places[k] for k in parents], [times[k] for k in parents]
        times = [ca.SX.sym("T") for _ in evaders]
        places = [place(int(i), time) for i, time in zip(evaders, times, strict=True)]
        for k, time in enumerate(times):
            distance = ca.norm_2(places[k] - before[k])
            equations.append(distance - pursuer_speed * (time - start[k]) - radius)
        variables += times
        radius = radii[1]
    programme = {
        "x": ca.veccat(turns, value, *variables),
        "f": -value,
        "g": ca.veccat(*equations, *(time - value for time in times)),
        "p": ca.veccat(starts, headings, speeds, rates, center, radii, pursuer_speed),
    }
    return programme, len(equations)
