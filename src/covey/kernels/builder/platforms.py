"""Shared libraries for the wheels: objects for several platforms, linked by `ziglang`."""

from __future__ import annotations

import subprocess
import sys
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from covey.kernels.builder.lower import Progress
from covey.kernels.builder.optimise import Target
from covey.kernels.builder.parts import built_parts
from covey.kernels.library.load import library_name


class Platform(NamedTuple):
    """A platform that wheels are built for."""

    wheel_tag: str
    triple: str  # as LLVM names the platform
    linker_target: str  # as the linker does
    system: str  # `sys.platform` there
    processors: Mapping[str, str]  # LLVM's name by generation, "" for any processor


_X86 = {"": "x86-64", "v3": "x86-64-v3"}
"""Any x86-64 processor, and those with AVX2, which most have since 2013 and all new ones have."""

PLATFORMS = {
    "linux-x86_64": Platform(
        "manylinux_2_17_x86_64",
        "x86_64-unknown-linux-gnu",
        "x86_64-linux-gnu.2.17",
        "linux",
        _X86,
    ),
    "linux-aarch64": Platform(
        "manylinux_2_17_aarch64",
        "aarch64-unknown-linux-gnu",
        "aarch64-linux-gnu.2.17",
        "linux",
        {"": "generic"},
    ),
    "macos-arm64": Platform(
        "macosx_11_0_arm64",
        "arm64-apple-macosx11.0.0",
        "aarch64-macos.11.0",
        "darwin",
        {"": "apple-m1"},
    ),
    "macos-x86_64": Platform(
        "macosx_11_0_x86_64", "x86_64-apple-macosx11.0.0", "x86_64-macos.11.0", "darwin", _X86
    ),
    "windows-x86_64": Platform(
        "win_amd64", "x86_64-w64-windows-gnu", "x86_64-windows-gnu", "win32", _X86
    ),
}


def build_libraries(names: Sequence[str], folder: Path, progress: Progress) -> None:
    """Write the libraries of platforms, each to the sub-folder of its name.

    All platforms share what numba lowers; LLVM optimises it for each.
    """
    wanted = [
        (name, generation, Target(PLATFORMS[name].triple, processor))
        for name in names
        for generation, processor in PLATFORMS[name].processors.items()
    ]
    built = built_parts([target for _, _, target in wanted], progress)
    for (name, generation, _), objects in zip(wanted, built, strict=True):
        platform = PLATFORMS[name]
        file = folder / name / library_name(platform.system, generation)
        file.parent.mkdir(parents=True, exist_ok=True)
        _link(objects, platform, file)


def _link(objects: Sequence[bytes], platform: Platform, file: Path) -> None:
    with tempfile.TemporaryDirectory() as folder:
        parts = [Path(folder) / f"{k}.o" for k in range(len(objects))]
        for part, compiled in zip(parts, objects, strict=True):
            part.write_bytes(compiled)
        linker = [sys.executable, "-m", "ziglang", "cc", "-target", platform.linker_target]
        command = [*linker, "-shared", "-s", "-o", str(file), *map(str, parts), "-lm"]
        subprocess.run(command, check=True)
