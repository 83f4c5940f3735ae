"""Folders with the results of a study: what loads can be summed up."""

from __future__ import annotations

import json
from io import BytesIO
from pathlib import Path
from tempfile import TemporaryDirectory
from zipfile import ZipFile

from hypothesis import strategies as st

import covey
from covey import studies
from covey.studies.running.manifest import NAME
from fuzz.mutation import damaged, edited
from fuzz.oracle import refusal, require
from fuzz.parquet import edited_table, encoded, parquet_cases
from fuzz.target import Target


def check(content):
    """Load the folder of a ZIP archive; sum up its games."""
    with TemporaryDirectory() as folder:
        ZipFile(BytesIO(content)).extractall(folder)
        try:
            return _summed_up(studies.load_study(folder))
        except covey.InputError as error:
            return refusal(error)


def _summed_up(result):
    lines = studies.summary(result)
    require(len(lines) == len(result.cases) > 0, f"{len(lines)} lines, {len(result.cases)} cases")
    require(isinstance(result.is_complete, bool), "is_complete")
    for table in result.trajectories():
        require(table.num_columns > 0, "trajectories without columns")
    return f"summed up, {'complete' if result.is_complete else 'incomplete'}"


def _folder_of(study):
    """Play a study; return the files of its folder by their names there."""
    with TemporaryDirectory() as folder:
        covey.run_study(study, folder, workers=1)
        files = sorted(Path(folder).rglob("*.*"))
        return {str(file.relative_to(folder)): file.read_bytes() for file in files}


def archive(files):
    """Return the ZIP archive of a folder's files."""
    buffer = BytesIO()
    with ZipFile(buffer, "w") as archive:
        for name, content in files.items():
            archive.writestr(name, content)
    return buffer.getvalue()


@st.composite
def _edited_folders(draw, files):
    """Draw a folder in which one or two files are others, or missing."""
    sound, files = files, dict(files)
    for _ in range(draw(st.integers(1, 2))):
        name = draw(st.sampled_from(sorted(sound)))
        kind = draw(st.sampled_from(("edited", "edited", "edited", "damaged", "missing")))
        if kind == "missing":
            files.pop(name, None)
        elif kind == "edited" and name == NAME:
            manifest = draw(edited(json.loads(sound[name]), ("format", "study", "grid")))
            files[name] = json.dumps(manifest).encode(errors="surrogatepass")
        elif kind == "edited" and name.endswith(".parquet"):
            files[name] = draw(parquet_cases([sound[name]], edited_table(sound[name]).map(encoded)))
        else:
            files[name] = draw(damaged(sound[name]))
    return archive(files)


FOLDER = _folder_of(
    studies.Study(
        starts=2,
        trajectories=True,
        team_size=(1, 2),
        update_time=0.3,
        objective=(covey.LastCapture(), covey.TotalSurvival()),
    )
)
TARGET = Target("results", ".zip", _edited_folders(FOLDER), check)
