"""Pursuit: a team of evaders that turn slowly against one pursuer that is faster than all of them.

The pursuer captures whomever it comes within ρ of. The team wants its last member to be captured as
late as possible, the pursuer as early as possible. These are the games of `covey.simulate`, step by
step: whatever both sides do, captures and times are the same.

=================  ======================================================================
import             ``from covey.envs import pursuit_v0``
PettingZoo         ``pursuit_v0.parallel_env(...)``; ``pursuit_v0.env(...)`` takes turns
Gymnasium          ``PursuerEnv``, ``TeamEnv``; by name ``covey/Pursuer-v0``, ``covey/Team-v0``
batches            ``PursuerVectorEnv``, ``TeamVectorEnv``
agents             ``evader_0`` ... ``evader_{N-1}``, ``pursuer_0``
action, evader     ``Box(-1, 1, (1,))``, its turn rate
action, pursuer    ``Box(-1, 1, (2,))``, its heading as a vector
observation        ``Box((6N + 3,))``, of every agent
=================  ======================================================================

All take the fields of `Setup` as keyword arguments: team size, speeds, turn rates, the pursuer's
speed and reach, what the team sees, the time of a step, where games start. Lengths and times are
in any consistent unit, angles are radians, counter-clockwise from +x.

**Steps.** A step takes Δt (`update_time`) or ends at the first capture in it, at its exact time:
everybody decides anew then. Episodes end when everybody is captured (terminated) or at `time_limit`
(truncated). Captured evaders leave `agents`.

**Actions.** An evader's action a in [-1, 1] is the turn rate that it averages over a whole step, as
a share of its largest, positive counter-clockwise. It turns by a ω Δt as every plan does (eq. 5 of
the paper): at full rate ω first, then it flies straight. That is at most a half turn; where the
rate is unlimited (inf), the evader turns at once, by a π.

The pursuer flies at full speed in the direction of its action. A vector has no seam at ±π, and its
length doesn't matter; only (0, 0) means something else: it waits.

**Observations** are relative to the observer's place, in axes that don't turn:

=================  ======================  ====================================================
numbers            range                   what
=================  ======================  ====================================================
6 for each evader
 0, 1              [-L, L]                 place, a length
 2, 3              [-v, v]                 velocity, length per time
 4                 [-π, π]                 turn it announced; 0 if its side has no strategy
 5                 {0, 1}                  1 while it lives; all are 0 once it is captured
3 at the end
 0, 1              [-L, L]                 centre of the disk that the team knows of
 2                 [0, L]                  its radius; 0 if the pursuer is visible
=================  ======================  ====================================================

v is the largest speed of an evader, L what two players can be apart at the time limit. To an evader
its own row comes first, then the others by number; to the pursuer and to a team that acts as one
they come by number. The team observes from the centre of its disk.

With ``sensing="hidden"`` the evaders know the pursuer by its disk alone: it grows at the pursuer's
speed and collapses, to the radius ρ, at each capture. The pursuer really flies inside it. It sees
the disk too.

**Rewards.** The time that a step takes, paid by the pursuer to the living evaders in equal shares:
zero-sum, and the whole team receives its survival time. In `TeamEnv` the team is paid as one.

**Infos.** ``"guarantee"``: the survival time that the team's first plan guarantees, or, where the
team doesn't plan, that `covey.plan` does from the same start (8 starts of its search).
``"time"``: the time now, at the end of a game the survival time.

**Opponents.** ``parallel_env(evaders=...)`` or ``parallel_env(pursuer=...)`` lets a strategy play
one side: any that comes with the package, or a function of a `covey.Situation`. Where the pursuer
starts is the environment's, also if its strategy has a `place`. `PursuerEnv` plays against
iterative open loop, `TeamEnv` against the committed pursuer, unless told otherwise. Batches play
compiled, against `covey.IterativeOpenLoop`, `covey.OpenLoop`, `covey.CommittedPursuer`,
`covey.UncommittedPursuer`, `covey.FixedSequence`, `covey.BestSequence`, `covey.RandomSequence`.
They begin a game anew in the step that ends it (Gymnasium's ``SAME_STEP``), and game b with seed s
is the game of the single view with seed s + b.

**Starts** are drawn. ``reset(options={"positions": (N, 2), "headings": (N,)})`` gives one; without
headings they are drawn as `Setup` says.
"""

import gymnasium

from covey.envs.parallel import PursuitEnv, env, parallel_env
from covey.envs.setup import Setup
from covey.envs.single import PursuerEnv, TeamEnv
from covey.envs.vector import PursuerVectorEnv, TeamVectorEnv

__all__ = [
    "PursuerEnv",
    "PursuerVectorEnv",
    "PursuitEnv",
    "Setup",
    "TeamEnv",
    "TeamVectorEnv",
    "env",
    "parallel_env",
]

for _side in ("Pursuer", "Team"):
    gymnasium.register(
        f"covey/{_side}-v0",
        entry_point=f"covey.envs.single:{_side}Env",
        vector_entry_point=f"covey.envs.vector:{_side}VectorEnv",
    )
