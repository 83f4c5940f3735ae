"""Check what a user installs: `python packaging/check_installed.py [WHEEL]`.

The wheel is installed in an empty environment outside of the checkout. There covey plans, plays a
study, serves the page and runs the first notebook. Without a wheel, the source distribution is
built from the checkout, and the wheel from the source distribution.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import time
import urllib.request
import venv
import zipfile
from pathlib import Path

CHECKOUT = Path(__file__).resolve().parents[1]
SOURCES = CHECKOUT / "src" / "covey"
PINS = CHECKOUT / "requirements" / "develop.txt"
PLAN = ["plan", "fig3", "--json"]


class Environment:
    """An environment with nothing but the wheel in it, and a folder of its own to work in."""

    def __init__(self, folder: Path, wheel: Path) -> None:
        venv.create(folder)
        self.folder = folder
        self.programs = Path(sysconfig.get_path("scripts", "venv", vars={"base": str(folder)}))
        self.work = folder / "work"
        self.work.mkdir()
        # Only what was installed is found.
        self.variables = {k: v for k, v in os.environ.items() if k != "PYTHONPATH"}
        self.pip("install", "--no-compile", "--no-deps", str(wheel))
        self.pip("install", "--no-compile", "--constraint", str(PINS), "covey[web]")

    def command(self, program: str, *arguments: str) -> list[str]:
        """Return the words that run a program of the environment."""
        return [str(self.programs / program), *arguments]

    def run(self, program: str, *arguments: str) -> subprocess.CompletedProcess[str]:
        """Run a program of the environment in its folder."""
        return self._succeed(self.command(program, *arguments))

    def pip(self, *arguments: str) -> subprocess.CompletedProcess[str]:
        """Run the checkout's pip on the environment: it is one that keeps to hashes."""
        pip = [sys.executable, "-m", "pip", "--python"]
        return self._succeed([*pip, str(self.folder), *arguments])

    def _succeed(self, command: list[str]) -> subprocess.CompletedProcess[str]:
        done = subprocess.run(
            command,
            cwd=self.work,
            env=self.variables,
            capture_output=True,
            encoding="utf-8",
            check=False,
        )
        require(done.returncode == 0, f"{' '.join(command)} failed:\n{done.stderr}")
        return done


def require(holds: bool, what: str) -> None:
    """End the check with a message unless a condition holds."""
    if not holds:
        sys.exit(f"check_installed: {what}")


def build(folder: Path) -> Path:
    """Build the source distribution, and the wheel from it; check and return the wheel."""
    build = [sys.executable, "-m", "build", "--no-isolation"]
    command = [*build, "--outdir", str(folder), str(CHECKOUT)]
    done = subprocess.run(command, capture_output=True, encoding="utf-8", check=False)
    require(done.returncode == 0, f"the package can't be built:\n{done.stdout}{done.stderr}")
    (source,), (wheel,) = folder.glob("*.tar.gz"), folder.glob("*.whl")
    with tarfile.open(source) as archive:
        require_sources(_below("src/covey/", archive.getnames()), source)
    with zipfile.ZipFile(wheel) as archive:
        require_sources(_below("covey/", archive.namelist()), wheel)
    return wheel


def _below(folder: str, names: list[str]) -> set[str]:
    """Return the names below a folder, which may itself be in a folder."""
    found = (re.fullmatch(rf"(?:covey-[^/]+/)?{folder}(.*)", name) for name in names)
    return {match[1] for match in found if match}


def require_sources(names: set[str], archive: Path) -> None:
    """Require that an archive has all files of the package, and no others."""
    files = (file for file in SOURCES.rglob("*") if file.is_file())
    wanted = {file.relative_to(SOURCES).as_posix() for file in files if file.suffix != ".pyc"}
    require(wanted <= names, f"{archive.name} lacks {sorted(wanted - names)}")
    require(names <= wanted, f"{archive.name} has too much: {sorted(names - wanted)}")


def check_plan(installed: Environment) -> None:
    """Check that the installed covey plans as the checkout does, with the same compiled kernels."""
    command = [sys.executable, "-m", "covey", *PLAN]
    here = subprocess.run(command, stdout=subprocess.PIPE, encoding="utf-8", check=True)
    there = installed.run("covey", *PLAN)
    require(here.stdout == there.stdout, "the installed covey has another plan for fig3")
    require("compiling" not in there.stderr, "the kernels were compiled a second time")


def check_study(installed: Environment) -> None:
    """Check that a shipped study can be copied, edited and played."""
    text = installed.run("covey", "show", "fig4").stdout
    file = installed.work / "fig4.toml"
    file.write_text(re.sub(r"(?m)^starts = \d+$", "starts = 2", text), encoding="utf-8")
    result = json.loads(installed.run("covey", "study", "fig4.toml", "--json").stdout)
    require(result["complete"] and result["games"] == 8, f"the study went wrong: {result}")


def check_page(installed: Environment) -> None:
    """Check that `covey chase` serves its page."""
    command = installed.command("covey", "chase", "--no-browser", "--port", "0")
    with subprocess.Popen(
        command,
        cwd=installed.work,
        env=installed.variables,
        stdout=subprocess.PIPE,
        encoding="utf-8",
    ) as server:
        try:
            found = re.search(r"http://\S+", server.stdout.readline() if server.stdout else "")
            require(found is not None, "covey chase didn't say where its page is")
            with urllib.request.urlopen(found[0] if found else "", timeout=30) as page:
                require(b"covey chase" in page.read(), "covey chase serves another page")
        finally:
            server.terminate()


def check_notebook(installed: Environment) -> None:
    """Check that the first notebook runs where there is no Jupyter."""
    installed.run("covey", "notebook", "--no-browser")
    page = (installed.work / "first_notebook.html").read_text(encoding="utf-8")
    require(page.count("data:image/png") == 2, "the first notebook lacks its pictures")


def check_compiler(installed: Environment) -> None:
    """Check that a wheel with the compiled kernels inside came without the compiler."""
    found = installed.pip("list", "--format=freeze").stdout
    require("numba" not in found and "llvmlite" not in found, "the compiler was installed")


def main(given: list[str]) -> None:
    """Build, unless a wheel is given, install, and check; say how long it took."""
    began = time.monotonic()
    with tempfile.TemporaryDirectory(prefix="covey-") as folder:
        wheel = Path(given[0]) if given else build(Path(folder) / "dist")
        print(f"{wheel.name} {'is given' if given else 'built from its sources'}", flush=True)
        installed = Environment(Path(folder).resolve() / "environment", wheel)
        print("installed it in an empty environment", flush=True)
        if "-any" not in wheel.name:
            check_compiler(installed)
        for check in (check_plan, check_study, check_page, check_notebook):
            check(installed)
    print(
        f"there it plans, studies, chases, runs a notebook; {time.monotonic() - began:.0f} s in all"
    )


if __name__ == "__main__":
    main(sys.argv[1:])
