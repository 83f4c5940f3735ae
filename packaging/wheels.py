"""Build wheels with the compiled kernels inside: `python packaging/wheels.py [PLATFORM ...]`.

Without a platform, for this machine's; "all" is every platform of `covey.kernels.builder`. The
wheels of other platforms are built, but cannot be tried here.
"""

from __future__ import annotations

import os
import platform
import subprocess
import sys
import tempfile
from pathlib import Path

from covey.kernels.builder.platforms import PLATFORMS, build_libraries

CHECKOUT = Path(__file__).resolve().parents[1]
DIST = CHECKOUT / "dist"
SYSTEMS = {"linux": "linux", "darwin": "macos", "win32": "windows"}
MACHINES = {"AMD64": "x86_64"}  # as Windows says it


def this_platform() -> str:
    """Return the name of this machine's platform."""
    machine = platform.machine()
    return f"{SYSTEMS.get(sys.platform, sys.platform)}-{MACHINES.get(machine, machine)}"


def main(wanted: list[str]) -> None:
    """Build the libraries, and a wheel around each."""
    names = list(PLATFORMS) if wanted == ["all"] else wanted or [this_platform()]
    unknown = [name for name in names if name not in PLATFORMS]
    if unknown:
        sys.exit(f"no wheels for {', '.join(unknown)}; there are: {', '.join(PLATFORMS)}")
    print(f"compiling the kernels for {', '.join(names)}", flush=True)
    with tempfile.TemporaryDirectory() as folder:
        build_libraries(names, Path(folder), _show)
        for name in names:
            wheel = _build_wheel(name, Path(folder) / name)
            if name == this_platform():
                check = CHECKOUT / "packaging" / "check_installed.py"
                subprocess.run([sys.executable, str(check), str(wheel)], check=True)
            else:
                print(f"{wheel.name}: built, but untried: it can't run on this machine")


def _show(share: float) -> None:
    if sys.stderr.isatty():
        print(f"\r{share:4.0%}", end="\n" if share == 1.0 else "", file=sys.stderr, flush=True)


def _build_wheel(name: str, libraries: Path) -> Path:
    settings = {
        "COVEY_WHEEL_LIBRARIES": str(libraries),
        "COVEY_WHEEL_TAG": f"py3-none-{PLATFORMS[name].wheel_tag}",
    }
    build = [sys.executable, "-m", "build", "--no-isolation", "--wheel"]
    command = [*build, "--outdir", str(DIST), str(CHECKOUT)]
    subprocess.run(command, env={**os.environ, **settings}, check=True, stdout=subprocess.PIPE)
    (wheel,) = DIST.glob(f"*-{PLATFORMS[name].wheel_tag}.whl")
    return wheel


if __name__ == "__main__":
    main(sys.argv[1:])
