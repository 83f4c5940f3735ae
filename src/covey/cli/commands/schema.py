"""`covey schema`: what editors complete and check files by."""

from __future__ import annotations

from typing import Annotated, Literal

from cyclopts import Parameter

from covey.cli.show.json_output import print_json


def schema(
    kind: Annotated[Literal["scenario", "study"], Parameter(help="The kind of file.")], /
) -> None:
    """Print the JSON schema of scenarios or studies, by which editors complete and check TOML.

    Name the saved schema in the first line of a file: `#:schema scenario.schema.json`.

    Try:

        covey schema scenario > scenario.schema.json
    """
    # Only now, as both load pydantic and NumPy.
    from covey.scenarios.json_schema import json_schema
    from covey.scenarios.schema import ScenarioFile
    from covey.studies.design.study_file import StudyFile

    model = ScenarioFile if kind == "scenario" else StudyFile
    print_json(json_schema(model, f"A {kind} of covey"))
