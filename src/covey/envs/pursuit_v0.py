"""Pursuit: to be written."""

from covey.envs.parallel import PursuitEnv, env, parallel_env
from covey.envs.setup import Setup
from covey.envs.single import PursuerEnv, TeamEnv
from covey.envs.vector import PursuerVectorEnv, TeamVectorEnv

__all__ = ["PursuerEnv", "PursuitEnv", "TeamEnv", "env", "parallel_env", "Setup", "PursuerVectorEnv", "TeamVectorEnv"]
