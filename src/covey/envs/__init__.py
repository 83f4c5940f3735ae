"""Learning environments, for PettingZoo and Gymnasium; they need `pip install 'covey[env]'`.

Read `pursuit_v0` first (the description), then `setup` (the game) and `episode` (one game, step by
step), on which `parallel` and `single` build. `batch` and `vector` play many games at once.
"""

try:
    from covey.envs import pursuit_v0
except ModuleNotFoundError as error:
    if error.name not in {"gymnasium", "pettingzoo"}:
        raise
    raise ImportError(f"covey.envs needs {error.name}: pip install 'covey[env]'") from error

__all__ = ["pursuit_v0"]
