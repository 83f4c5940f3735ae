"""The README's programs print what the README says."""

from __future__ import annotations

import re
from pathlib import Path

README = Path(__file__).parents[1] / "README.md"


def test_programs_print_what_it_says(capsys):
    text, names = README.read_text(), {}
    told = re.findall(r"```python\n(.*?)```\n\n```text\n(.*?)```", text, re.DOTALL)
    assert len(told) == text.count("```python")
    for program, printed in told:
        exec(compile(program, "README.md", "exec"), names)
        assert capsys.readouterr().out == printed
