"""How a value looks: one line at the prompt, a small table in a notebook."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from enum import Enum
from html import escape
from itertools import islice

from covey.model.units import with_unit
from covey.model.validation import Floats

_MOST_ROWS = 20


def one_line(kind: str, *facts: str, **named: object) -> str:
    """Write a value as kind(fact, ..., name=value, ...), numbers to six digits."""
    return f"{kind}({', '.join([*facts, *(f'{name}={brief(v)}' for name, v in named.items())])})"


def brief(value: object) -> str:
    """Write a number to six digits, a tuple of such, or the name of a status."""
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, tuple):
        return f"({', '.join(map(brief, value))})"
    return value.name if isinstance(value, Enum) else str(value)


def angle_text(value: float) -> str:
    """Write an angle or a turn rate as files do: "pi/2", or a number to six digits."""
    found = multiple_of_pi(value)
    if found is None:
        return brief(value)
    factor, divisor = found
    times = "pi" if factor == 1 else f"{factor} pi"
    return times if divisor == 1 else f"{times}/{divisor}"


def multiple_of_pi(value: float) -> tuple[int, int] | None:
    """Return k and n if a value is a simple multiple k π/n; None: it is another number."""
    for divisor in (1, 2, 3, 4, 6, 8):
        factor = value * divisor / math.pi
        if 0.5 < factor < 9.5 and abs(factor - round(factor)) < 1e-9:
            return round(factor), divisor
    return None


def quantity(value: object, unit: str) -> str:
    """Write a number to six digits, or a tuple of such, with its unit if there is one."""
    return with_unit(brief(value), unit)


def html_facts(caption: str, facts: Mapping[str, object]) -> str:
    """Write a table of facts, a row each."""
    return html_table(caption, {"": facts.keys(), "value": facts.values()})


def html_row(caption: str, facts: Mapping[str, object]) -> str:
    """Write a table of facts, a column each."""
    return html_table(caption, {name: [value] for name, value in facts.items()})


def spread(values: Floats, write: Callable[[float], str] = brief) -> str:
    """Write the value (N,) that all evaders have, or the least and the largest one."""
    least, largest = float(values.min()), float(values.max())
    return write(least) if least == largest else f"{write(least)} to {write(largest)}"


def html_table(caption: str, columns: Mapping[str, Iterable[object]]) -> str:
    """Write a table of columns by their headings, of which the first rows are shown."""
    rows = [*islice(zip(*columns.values(), strict=True), _MOST_ROWS + 1)]
    if len(rows) > _MOST_ROWS:
        rows[_MOST_ROWS] = ("…",) * len(columns)
    head = "".join(f"<th>{escape(name)}</th>" for name in columns)
    body = "".join(
        "<tr>" + "".join(f"<td>{escape(brief(cell))}</td>" for cell in row) + "</tr>"
        for row in rows
    )
    return (
        f"<table><caption>{escape(caption)}</caption>"
        f"<thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"
    )
