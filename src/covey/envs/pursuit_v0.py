"""Pursuit: to be written."""

from covey.envs.parallel import PursuitEnv, env, parallel_env
from covey.envs.single import PursuerEnv, TeamEnv

__all__ = ["PursuerEnv", "PursuitEnv", "TeamEnv", "env", "parallel_env"]
