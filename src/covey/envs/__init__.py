"""Learning environments: PettingZoo's and Gymnasium's views of the game.

`from covey.envs import pursuit_v0`; they need `pip install 'covey[env]'`.
"""

try:
    from covey.envs import pursuit_v0
except ModuleNotFoundError as error:
    if error.name not in {"gymnasium", "pettingzoo"}:
        raise
    raise ImportError(f"covey.envs needs {error.name}: pip install 'covey[env]'") from error

__all__ = ["pursuit_v0"]
