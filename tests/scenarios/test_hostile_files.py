"""Files that a program might choke on: each gets one short message, and soon."""

from __future__ import annotations

import pytest

import covey
from covey.scenarios import load_scenario
from covey.scenarios.values.kinds import as_angle
from covey.studies import read_study

EVADER = "[[team.evaders]]\nposition = [0.3, 0.1]\n"

HOSTILE = {
    "deep inline tables": ("a = " + "{b = " * 5000 + "1" + "}" * 5000, "levels deep"),
    "deep lists": ("a = " + "[" * 60 + "]" * 60, "levels deep"),
    "deep keys": (".".join("a" * 3000) + " = 1", "levels deep"),
    "a number of 5 000 digits": (EVADER + "speed = " + "9" * 5000, "TOML"),
    "a file of 2 MB": ("# " + "x" * 2_000_000, "at most 1 MB"),
    "digits without end": (EVADER + f'heading = "{"1" * 50_000}"', "a heading"),
    "signs without end": (EVADER + f'heading = "{"+-" * 20_000} pi"', "a heading"),
    "a thousand mistakes": ("\n".join(f"key{k} = 1" for k in range(1000)), "and 99[0-9] more"),
}


@pytest.mark.parametrize(("text", "message"), HOSTILE.values(), ids=HOSTILE)
@pytest.mark.parametrize("load", [load_scenario, read_study])
def test_a_hostile_file_is_one_short_message(load, text, message, tmp_path):
    file = tmp_path / "hostile.toml"
    file.write_text(text, encoding="utf-8")
    with pytest.raises(covey.InputError) as caught:
        load(file)
    told = str(caught.value)
    assert len(told) < 4000
    if load is load_scenario:
        assert caught.match(message)


@pytest.mark.parametrize("text", ["1" * 60 + "x", "+" * 60, "1e" * 30, " " * 60])
def test_an_angle_that_is_none_is_seen_at_once(text):
    assert as_angle(text) is None
