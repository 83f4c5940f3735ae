"""Files that are cut at any byte, as a power cut leaves them, or have a wrong bit."""

from __future__ import annotations

from pathlib import Path
from random import Random

from faults.outcome import require_told
from faults.study import RESULTS, play, put_files, require_goes_on, undisturbed

MANIFEST = "manifest.json"


def damage(random: Random, content: bytes) -> bytes:
    """Return the content without its end, or with a wrong bit."""
    position = random.randrange(len(content))
    if random.random() < 0.5:
        return content[:position]
    wrong = content[position] ^ (1 << random.randrange(8))
    return content[:position] + bytes([wrong]) + content[position + 1 :]


def damaged_parts(random: Random, folder: Path) -> None:
    """About half of a study's files of games and trajectories are damaged; they are played anew."""
    whole = undisturbed().files
    put_files(
        folder,
        {
            name: damage(random, content) if name != MANIFEST and random.random() < 0.5 else content
            for name, content in whole.items()
        },
    )
    require_goes_on(folder)


def cut_manifest(random: Random, folder: Path) -> None:
    """The manifest of a study is cut, and the run says so."""
    whole = undisturbed().files
    cut = whole[MANIFEST][: random.randrange(len(whole[MANIFEST]) - 1)]
    put_files(folder, whole | {MANIFEST: cut})
    require_told(play(folder), [2])
    (folder / RESULTS / MANIFEST).write_bytes(whole[MANIFEST])
    require_goes_on(folder)
