"""Each mistake is met by an error that says what was wanted and what came."""

from __future__ import annotations

import math
import subprocess
import sys

import pytest

import covey
from covey import InputError
from covey.envs import pursuit_v0
from covey.envs.setup import TEAM


@pytest.mark.parametrize(
    ("setup", "message"),
    [
        ({"team_size": 0}, "team_size: expected a whole number >= 1, got 0"),
        ({"team_size": 51}, "at most 50 evaders, got 51"),
        ({"speed": 1.0}, "slower than the pursuer"),
        ({"speed": [0.1, 0.2]}, "one for each of 3 evaders"),
        ({"turn_rate": -1.0}, "turn_rates: expected numbers >= 0"),
        ({"capture_radius": 0.0}, "capture_radius: expected a finite number > 0, got 0"),
        ({"disk_radius": -0.1}, "radius: expected a finite number >= 0"),
        ({"update_time": 0.0}, "update_time: expected a finite number > 0"),
        ({"time_limit": math.inf}, "time_limit: expected a finite number > 0, got inf"),
        ({"side": math.nan}, "side: expected a finite number > 0"),
        ({"sensing": "blind"}, "sensing: expected one of hidden, visible, got 'blind'"),
        ({"headings": "north"}, "headings: expected one of away, random, got 'north'"),
        ({"render_mode": "ascii"}, "render_mode: expected one of human, rgb_array, got 'ascii'"),
        ({"evaders": TEAM, "pursuer": covey.CommittedPursuer()}, "one side at most, got both"),
    ],
)
def test_setup(setup, message):
    with pytest.raises(InputError, match=message):
        pursuit_v0.parallel_env(**setup)


def test_an_unknown_field():
    with pytest.raises(TypeError, match="team_sise"):
        pursuit_v0.parallel_env(team_sise=3)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"positions": [[0.0, 0.0]]}, r"positions: expected an array of shape \(3, 2\)"),
        ({"positions": [[0.0, 0.6]] * 3}, "in a square of side 1 around the origin"),
        ({"headings": [0.0, 0.0, 0.0]}, "headings: expected positions with them"),
    ],
)
def test_options(options, message):
    with pytest.raises(InputError, match=message):
        pursuit_v0.TeamEnv().reset(options=options)


@pytest.mark.parametrize(
    ("actions", "message"),
    [
        ({"pursuer_0": [1.0, 0.0]}, "expected one for each of"),
        ({"evader_0": [1.2], "evader_1": [0.0], "pursuer_0": [1.0, 0.0]}, "evader_0: .* in"),
        (
            {"evader_0": [0.0], "evader_1": [0.0], "pursuer_0": [1.0]},
            "pursuer_0: expected an array",
        ),
        (
            {"evader_0": [0.0], "evader_1": [math.nan], "pursuer_0": [1.0, 0.0]},
            "evader_1: .* finite",
        ),
    ],
)
def test_actions(actions, message):
    env = pursuit_v0.parallel_env(team_size=2)
    env.reset(seed=0)
    before = env._episode.time
    with pytest.raises(InputError, match=message):
        env.step(actions)
    assert env._episode.time == before  # and the game can go on
    env.step({"evader_0": [0.0], "evader_1": [0.0], "pursuer_0": [1.0, 0.0]})


def test_batches():
    with pytest.raises(InputError, match="num_envs: expected a whole number >= 1"):
        pursuit_v0.PursuerVectorEnv(0)
    with pytest.raises(InputError, match="SyncVectorEnv over PursuerEnv"):
        pursuit_v0.PursuerVectorEnv(2, evaders=lambda situation: [0.0])
    with pytest.raises(InputError, match="SyncVectorEnv over TeamEnv"):
        pursuit_v0.TeamVectorEnv(2, pursuer=lambda situation: covey.Fly())
    games = pursuit_v0.PursuerVectorEnv(2)
    with pytest.raises(InputError, match="seed: expected 2 seeds, got 3"):
        games.reset(seed=[1, 2, 3])
    games.reset(seed=0)
    with pytest.raises(InputError, match=r"actions: expected an array of shape \(2, 2\)"):
        games.step([[1.0, 0.0]])


def test_before_the_first_reset():
    assert pursuit_v0.parallel_env().step({}) == ({}, {}, {}, {}, {})
    env = pursuit_v0.PursuerEnv(render_mode="rgb_array")
    with pytest.raises(InputError, match=r"call reset\(\) first"):
        env.step([1.0, 0.0])
    with pytest.raises(InputError, match=r"call reset\(\) first"):
        env.render()
    with pytest.raises(InputError, match=r"call reset\(\) first"):
        pursuit_v0.TeamVectorEnv(2).step([[0.0, 0.0, 0.0]] * 2)


def test_after_the_end():
    env = pursuit_v0.PursuerEnv(time_limit=0.04)
    env.reset(seed=0)
    env.step([1.0, 0.0])
    with pytest.raises(InputError, match=r"this one has ended; call reset\(\)"):
        env.step([1.0, 0.0])


def run(code):
    return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)


@pytest.mark.parametrize("missing", ["pettingzoo", "gymnasium"])
def test_without_the_extra(missing):
    done = run(f"import sys; sys.modules['{missing}'] = None; import covey; covey.envs")
    assert done.returncode == 1
    assert f"covey.envs needs {missing}: pip install 'covey[env]'" in done.stderr


def test_pictures_without_pygame():
    done = run(
        "import sys; sys.modules['pygame'] = None\n"
        "from covey.envs import pursuit_v0\n"
        "env = pursuit_v0.PursuerEnv(render_mode='rgb_array'); env.reset(seed=0); env.render()"
    )
    assert done.returncode == 1
    assert "pip install 'covey[env]'" in done.stderr


def test_the_rest_of_covey_loads_none_of_it():
    done = run(
        "import sys, covey; covey.simulate; covey.run_study\n"
        "assert not {'gymnasium', 'pettingzoo', 'pygame'} & set(sys.modules)"
    )
    assert done.returncode == 0, done.stderr
    done = run("import sys, covey; covey.envs.pursuit_v0; assert 'pygame' not in sys.modules")
    assert done.returncode == 0, done.stderr
