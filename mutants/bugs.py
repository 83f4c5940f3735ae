"""Bugs that a competent person could make, each in one place, written down before any was tried.

Each bug is wrong for a user: it changes a result, drops a check or loses work. None of them only
changes words or speed.
"""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple


class Bug(NamedTuple):
    """A text of one file that another text replaces."""

    name: str
    file: str  # below src/covey
    old: str
    new: str
    harm: str  # what the bug does to a user

    @property
    def room(self) -> str:
        """The room that the bug is in."""
        return self.file.split("/")[0]

    def plant(self, package: Path) -> None:
        """Change the file of a package; LookupError unless the old text stands there once."""
        path = package / self.file
        source = path.read_text(encoding="utf-8")
        if source.count(self.old) != 1:
            raise LookupError(f"{self.name}: {self.file} holds the text {source.count(self.old)}x")
        path.write_text(source.replace(self.old, self.new), encoding="utf-8")


KERNELS = (
    Bug(
        "right turn mirrored by half",
        "kernels/capture/interception.py",
        "        across, half_rate = -across, -half_rate",
        "        half_rate = -half_rate",
        "captures of evaders that turn right come at wrong times",
    ),
    Bug(
        "half a mixed derivative",
        "kernels/capture/derivatives.py",
        "            if j >= i:\n                hessian[j, i]",
        "            if j > i:\n                hessian[j, i]",
        "the planner's second derivatives are wrong; plans converge slowly, or short of the best",
    ),
    Bug(
        "one reach for many captures",
        "kernels/minimum/deadlines.py",
        "granted, slack = n * pursuit.later_radius, ",
        "granted, slack = pursuit.later_radius, ",
        "with a capture radius a better sequence is pruned, and the guarantee is too high",
    ),
    Bug(
        "pairs of an earlier call",
        "kernels/minimum/total_time.py",
        "remembered = scratch.stamps[state] == scratch.call[0]",
        "remembered = scratch.stamps[state] > 0",
        "the least sum of a game depends on the games before it",
    ),
    Bug(
        "disk collapses to a point",
        "kernels/play/rules.py",
        "        disk[2] = rules.reach",
        "        disk[2] = 0.0",
        "after a capture the team knows more than it can, and its guarantee is broken",
    ),
    Bug(
        "team before the capture",
        "kernels/play/policy.py",
        "forget(memory, n + 1, captured_row)",
        "forget(memory, n, captured_row)",
        "after a capture the team's sequences hold evaders twice, or captured ones",
    ),
    Bug(
        "delay begins anew",
        "kernels/play/to_capture.py",
        "contained_since = min(contained_since, state.time[0])",
        "contained_since = state.time[0]",
        "a pursuer that waits never captures: no worst case with delays",
    ),
    Bug(
        "one side of the border",
        "kernels/bounds/fixed_sequence.py",
        "best >= nodes - 2",
        "best >= nodes - 1",
        "the search narrows beside the maximum; known sequences get too small a value",
    ),
    Bug(
        "away from the origin",
        "kernels/maximum/initial_guesses.py",
        "off_x, off_y = evaders[i, X] - pursuit.center_x, evaders[i, Y] - pursuit.center_y",
        "off_x, off_y = evaders[i, X], evaders[i, Y]",
        "the first guess is worse, the farther the disk is from the origin",
    ),
    Bug(
        "newest kernels forgotten",
        "kernels/library/cache.py",
        "by_age[:-_MOST_FILES]",
        "by_age[_MOST_FILES:]",
        "after eight versions every process compiles again",
    ),
)

MODEL = (
    Bug(
        "weights that sum to zero",
        "model/objectives.py",
        "if not 0.0 < sum(kept) < math.inf:",
        "if not 0.0 <= sum(kept) < math.inf:",
        "weights of zero give nan everywhere in place of an error",
    ),
    Bug(
        "past the goal",
        "model/pursuer_disk.py",
        "np.minimum(lengths, distance)[..., np.newaxis]",
        "np.asarray(lengths)[..., np.newaxis]",
        "a pursuer that starts near its first capture flies past it",
    ),
    Bug(
        "array of the caller",
        "model/validation.py",
        "array: npt.NDArray[Any] = np.array(value)",
        "array: npt.NDArray[Any] = np.asarray(value)",
        "the caller's own array becomes read-only, and a change of it changes a frozen team",
    ),
)

PLANNING = (
    Bug(
        "critical sequences unsorted",
        "planning/open_loop.py",
        "for each, sequence, weight in sorted(rows) if each <= latest]",
        "for each, sequence, weight in rows if each <= latest]",
        "the first critical sequence isn't the worst; pictures show a wrong capture order",
    ),
    Bug(
        "seed without effect",
        "planning/open_loop.py",
        "np.random.default_rng(seed).uniform",
        "np.random.default_rng(0).uniform",
        "another seed searches the same guesses again",
    ),
    Bug(
        "goal headings not wrapped",
        "planning/open_loop.py",
        "goal_headings=read_only(wrap_angle(team.headings + turns)),",
        "goal_headings=read_only(team.headings + turns),",
        "goal headings lie outside of [-π, π]",
    ),
    Bug(
        "turns of evaders that can't turn",
        "planning/open_loop.py",
        "return np.where(team.turn_rates > 0.0, checked, 0.0)",
        "return checked.copy()",
        "a plan from a warm start tells an evader that can't turn to turn",
    ),
    Bug(
        "workspace of all threads",
        "planning/workspace.py",
        "_kept = threading.local()",
        '_kept = type("Kept", (), {})()',
        "plans in two threads at once overwrite each other's memory",
    ),
    Bug(
        "batch past the last guess",
        "planning/multistart.py",
        "range(first, min(first + BATCH, count))",
        "range(first, first + BATCH)",
        "a search reads random numbers beyond the end of their array",
    ),
)

BOUNDS = (
    Bug(
        "one evader bounded from the origin",
        "bounds/polygon_bound.py",
        "np.zeros(1), opening.end[np.newaxis, :]",
        "np.zeros(1), np.zeros((1, 2))",
        "the upper bound of one evader is wrong where the disk isn't at the origin",
    ),
    Bug(
        "opening towards the wrong evader",
        "bounds/polygon_bound.py",
        "[first : first + 1]",
        "[:1]",
        "the bounding pursuer begins in a wrong direction; the bound is loose",
    ),
    Bug(
        "a turn that costs nothing",
        "bounds/reachable_hull.py",
        "radius * (off - np.sin(off))",
        "radius * (off - off)",
        "the upper end forgets what turning costs; the bound is loose",
    ),
    Bug(
        "turn limits known for too long",
        "bounds/polygon_bound.py",
        "(disk.speed - team.speeds[previous]) * time",
        "(disk.speed + team.speeds[previous]) * time",
        "an evader is taken to turn when it turns no more; the bound may be wrong",
    ),
    Bug(
        "value at pursuer speed 1",
        "bounds/two_evaders.py",
        "return float(self.at(team.positions - disk.center)) / disk.speed",
        "return float(self.at(team.positions - disk.center))",
        "the true value of two evaders is wrong for other speeds of the pursuer",
    ),
)

SIMULATION = (
    Bug(
        "flight from time 0",
        "simulation/build_record.py",
        "share = (log.times[row:last] - since) / (time - since)",
        "share = log.times[row:last] / time",
        "the recorded pursuer jumps after the first capture",
    ),
    Bug(
        "damage unnoticed",
        "simulation/storage.py",
        "if notes[_CHECKSUM_KEY] != _checksum(notes[_KEY], table):",
        "if _CHECKSUM_KEY not in notes:",
        "a record whose numbers were changed is loaded as if it were sound",
    ),
    Bug(
        "rows by number",
        "simulation/information.py",
        "np.array([living.index(i) for i in sequence], dtype=np.int64)",
        "np.array(sequence, dtype=np.int64)",
        "after a capture a pursuer in Python chases another evader than it named",
    ),
    Bug(
        "place seen from the origin",
        "simulation/strategy.py",
        "distance = float(np.hypot(*(position - disk.center)))",
        "distance = float(np.hypot(*position))",
        "a legal place in a disk away from the origin is refused",
    ),
    Bug(
        "intention a row late",
        "simulation/match.py",
        "self._log.intended[self._log.counters[ROWS] - 1, : len(decision.rows)]",
        "self._log.intended[self._log.counters[ROWS], : len(decision.rows)]",
        "the record shows a sequence before the pursuer had it in mind",
    ),
)

PLAYERS = (
    Bug(
        "interval counted once",
        "players/teams/replan_interval.py",
        "planned_at, living = situation.time, situation.evaders",
        "living = situation.evaders",
        "after the first interval a team plans at every update, whatever its replan_time",
    ),
    Bug(
        "position by number",
        "players/pursuers/delayed.py",
        "situation.team.positions[situation.evaders.index(target)]",
        "situation.team.positions[target]",
        "a pursuer that waits looks at another evader than its target",
    ),
    Bug(
        "one random order",
        "players/pursuers/fixed_order.py",
        "np.random.default_rng([seed, 1])",
        "np.random.default_rng(1)",
        "the random pursuer takes the same order in every game",
    ),
    Bug(
        "waits cut off",
        "players/worst_case.py",
        "settings = replace(checked, time_limit=math.inf)",
        "settings = checked",
        "long delays end in an error about update_time, or at a wrong time",
    ),
    Bug(
        "turns not refined",
        "players/teams/lookahead.py",
        "        width /= _REFINEMENT\n",
        "",
        "teams that look ahead turn by multiples of 11 degrees",
    ),
    Bug(
        "pursuit from time 0",
        "players/teams/largest_distance.py",
        "return least, captured_at(paths, there, threat.time)",
        "return least, captured_at(paths, there)",
        "ties between turns are decided by a pursuer that starts too early",
    ),
)

SCENARIOS = (
    Bug(
        "own turn rate ignored",
        "scenarios/build.py",
        "    if evader.turn_rate is not None:\n        return evader.turn_rate\n",
        "",
        "the turn rate of a single evader in a file has no effect",
    ),
    Bug(
        "time limit ignored",
        "scenarios/scenario.py",
        "            time_limit=self.time_limit,\n",
        "",
        "the time limit of a file has no effect",
    ),
    Bug(
        "random team at the origin",
        "scenarios/build.py",
        "positions = (offsets + np.array(center)).tolist()",
        "positions = offsets.tolist()",
        "a random team isn't placed around the pursuer's disk",
    ),
    Bug(
        "formation off its middle",
        "scenarios/samplers.py",
        "        slots -= slots.mean(axis=0)\n",
        "",
        "formations start nearer or farther than the distance that was asked for",
    ),
)

STUDIES = (
    Bug(
        "interval too narrow",
        "studies/analysis/paired_ratios.py",
        "float(deviations.std(ddof=1)) / count**0.5",
        "float(deviations.std(ddof=1)) / count",
        "confidence intervals of a tournament are far too narrow",
    ),
    Bug(
        "game in place of start",
        "studies/running/scheduler.py",
        "start = error.number // len(self._study.cases)",
        "start = error.number",
        "the report of a failed game names another start",
    ),
    Bug(
        "survivors left out",
        "studies/design/as_visible.py",
        "return FixedSequence([*captured, *rest])",
        "return FixedSequence(captured)",
        "the hidden game fails where the visible one was stopped at its time limit",
    ),
    Bug(
        "first case for all sizes",
        "studies/analysis/summary.py",
        'base = bases.setdefault(case["team_size"], k)',
        'base = bases.setdefault("first", k)',
        "larger teams are compared with a smaller team",
    ),
    Bug(
        "starts in the order of the file",
        "studies/design/start_table.py",
        "return digest, Starts(rows[order], ",
        "return digest, Starts(rows, ",
        "a table of starts that isn't sorted mixes evaders of several starts",
    ),
    Bug(
        "versions mixed",
        "studies/running/manifest.py",
        '[*_differences(before, now, "study"), *_differences(before, now, "versions")]',
        '[*_differences(before, now, "study")]',
        "a study is finished by other code than began it",
    ),
)

VIEWS = (
    Bug(
        "disk stands still",
        "views/games/snapshot.py",
        "game.disk_radii[row] + game.disk.speed * elapsed,",
        "game.disk_radii[row],",
        "between two rows of a record the pursuer's disk is drawn too small",
    ),
    Bug(
        "all turns to the left",
        "views/games/flight.py",
        "np.copysign(np.fmin(np.abs(turns), team.turn_rates * elapsed), turns)",
        "np.fmin(np.abs(turns), team.turn_rates * elapsed)",
        "evaders that turn right are drawn off their path",
    ),
    Bug(
        "last bin missing",
        "views/charts/ratios.py",
        "np.arange(low, high + 2)",
        "np.arange(low, high + 1)",
        "the largest ratios are left out of the histogram",
    ),
    Bug(
        "camera by the shorter side",
        "views/kit/layout.py",
        "side = float(np.max(high - low)) or 1.0",
        "side = float(np.min(high - low)) or 1.0",
        "parts of a game lie outside of its picture",
    ),
)

ENVS = (
    Bug(
        "one game many times",
        "envs/batch.py",
        "[None if seed is None else int(seed) + b for b in range(self.num_envs)]",
        "[None if seed is None else int(seed) for b in range(self.num_envs)]",
        "a batch with a seed plays the same game in all its places",
    ),
    Bug(
        "shares of the dead",
        "envs/parallel.py",
        "sharing = len(episode.living)",
        "sharing = self.setup.team_size",
        "after a capture the rewards no longer sum to the survival time",
    ),
    Bug(
        "actions of the first rows",
        "envs/episode.py",
        "(shares * self.setup.largest_turns)[self.living]",
        "(shares * self.setup.largest_turns)[:alive]",
        "after a capture evaders fly the actions of others",
    ),
    Bug(
        "guesses of another game",
        "envs/vector.py",
        "        part_of(self._memories.uniforms, b, self.num_envs)[:] = memory.uniforms\n",
        "",
        "games of a batch differ from the single game with the same seed",
    ),
)

WEB = (
    Bug(
        "all time made up for",
        "web/game/pacing.py",
        "self._owed += self.pace * min(now - self._last, _MOST_OWED)",
        "self._owed += self.pace * (now - self._last)",
        "after a pause of the machine the game leaps, and the evaders with it",
    ),
    Bug(
        "no origin is our own",
        "web/serving/origin.py",
        'return origin in {f"http://{host}", f"https://{host}"}',
        'return origin is None or origin in {f"http://{host}", f"https://{host}"}',
        "a program that sends no Origin header may play and use the processor",
    ),
    Bug(
        "reference game of another team",
        "web/game/human_game.py",
        "            update_time=UPDATE_TIME,\n            seed=self._choices.seed,\n",
        "            update_time=UPDATE_TIME,\n",
        "a person's score is set beside a game whose team planned from another seed",
    ),
    Bug(
        "new game under way",
        "web/game/session.py",
        "        game = HumanGame(message.choices)\n        self._pacer.pause()\n",
        "        game = HumanGame(message.choices)\n",
        "a new game begins at once while the person still looks at it",
    ),
)

CLI = (
    Bug(
        "places by number",
        "cli/show/json_output.py",
        "positions = game.evader_positions[-1, order].tolist()",
        "positions = game.evader_positions[-1].tolist()",
        "`--json` tells captures at the places of other evaders",
    ),
    Bug(
        "delays ignored",
        "cli/commands/worst_case.py",
        "scenario.worst_case(delays or [0.0])",
        "scenario.worst_case()",
        "`--delays` has no effect",
    ),
    Bug(
        "seed ignored",
        "cli/shared/sources.py",
        "return covey.load_scenario(name, seed=seed)",
        "return covey.load_scenario(name)",
        "`--seed` has no effect",
    ),
    Bug(
        "figures of missing games",
        "cli/commands/reproduce.py",
        "    print_study(result)\n    require_all_games(result)\n",
        "    print_study(result)\n",
        "the paper's figures are drawn, and reported, without the games that failed",
    ),
)

BUGS = (
    *KERNELS,
    *MODEL,
    *PLANNING,
    *BOUNDS,
    *SIMULATION,
    *PLAYERS,
    *SCENARIOS,
    *STUDIES,
    *VIEWS,
    *ENVS,
    *WEB,
    *CLI,
)
