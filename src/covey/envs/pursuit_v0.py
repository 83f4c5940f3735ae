"""Pursuit: a team of evaders that turn slowly against one pursuer that is faster than all of them.

The pursuer captures every evader that it comes within ρ of. The team wants its last member to be
captured as late as possible, the pursuer as early as possible. These are the games of
`covey.simulate`, step by step: the same decisions give the same captures and times.

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
speed and reach, what the team sees, the time of a step, initial states. Lengths and times are
in any consistent unit, angles are radians, counter-clockwise from +x.

**Steps.** A step takes Δt (`update_time`), or less if there is a capture: it ends at the exact time
of the capture, and everybody decides anew. Episodes end when everybody is captured (terminated) or
at `time_limit` (truncated). Captured evaders leave `agents`.

**Actions.** An evader's action a in [-1, 1] is its mean turn rate over a whole step, as a share of
its largest rate ω, positive counter-clockwise. The evader turns by a ω Δt as in every plan (eq. 5
of the paper): at full rate first, then it flies straight. It turns by at most π; an evader whose
rate is unlimited (inf) turns at once, by a π.

The pursuer flies at full speed in the direction of its action, a vector of any length. At (0, 0) it
waits. (An angle would have a jump at ±π.)

**Observations** are relative to the observer's position, in axes that don't turn:

=================  ======================  ====================================================
numbers            range                   what
=================  ======================  ====================================================
6 for each evader
 0, 1              [-L, L]                 position, a length
 2, 3              [-v, v]                 velocity, length per time
 4                 [-π, π]                 announced turn; 0 if its side has no strategy
 5                 {0, 1}                  1 while it lives; all are 0 once it is captured
3 at the end
 0, 1              [-L, L]                 centre of the disk that the team knows of
 2                 [0, L]                  its radius; 0 if the pursuer is visible
=================  ======================  ====================================================

v is the largest speed of an evader, L a bound on the distance of two players up to the time limit.
An evader sees its own row first, then the others by number. The pursuer, and a team that acts as
one, see the rows by number. The team observes from the centre of its disk.

With ``sensing="hidden"`` the evaders know only the pursuer's disk. The disk grows at the pursuer's
speed and collapses, to the radius ρ, at each capture. The pursuer flies inside the disk, and sees
it too.

**Rewards.** The pursuer pays the time of a step to the living evaders, in equal shares. The game is
zero-sum, and the whole team receives its survival time. In `TeamEnv` the team is paid as one.

**Infos.** ``"guarantee"``: the survival time that the team's first plan guarantees. A team that
doesn't plan has that of `covey.plan` for the same initial state (8 starts of its search).
``"time"``: the time now; at the end of a game, the survival time.

**Opponents.** ``parallel_env(evaders=...)`` or ``parallel_env(pursuer=...)`` lets a strategy play
one side: any that comes with the package, or a function of a `covey.Situation`. The environment
says where the pursuer starts, also if its strategy has a `place`. By default `PursuerEnv` plays
against iterative open loop, `TeamEnv` against the committed pursuer. Batches play compiled,
against `covey.IterativeOpenLoop`, `covey.OpenLoop`, `covey.CommittedPursuer`,
`covey.UncommittedPursuer`, `covey.FixedSequence`, `covey.BestSequence`, `covey.RandomSequence`.
They begin a game anew in the step that ends it (Gymnasium's ``SAME_STEP``). Game b with seed s is
the game of the single environment with seed s + b.

**Initial states** are drawn. ``reset(options={"positions": (N, 2), "headings": (N,)})`` sets one;
without ``"headings"``, these are drawn as `Setup` says.
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
