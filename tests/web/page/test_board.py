"""What is on the board and beside it: plans, signs, and everybody in sight."""

from __future__ import annotations

import re

import pytest

import covey
from web.browser_pages import CAPTURED, TEAM, colours


def test_the_board_shows_what_the_team_plans_and_hides_it_on_demand(open_page):
    tab = open_page("?start=fig3&sensing=hidden")
    tab.wait(lambda: "reference" in tab.heard)  # whose mark on the line of time has a colour, too
    tab.page.wait_for_timeout(500)  # until all is drawn, on a busy machine too
    _, count = colours(tab)
    planned, predicted = count(TEAM), count(CAPTURED)
    tab.page.get_by_role("switch").uncheck()
    tab.page.wait_for_timeout(500)
    _, count = colours(tab)
    assert 0 < count(TEAM) < planned - 200  # the evaders are still there, their plans are not
    assert count(CAPTURED) < predicted - 50


@pytest.mark.parametrize(
    ("time", "earlier", "shown"),
    [(5.234, 4.838, "0.39"), (5.225, 4.8449, "0.38"), (3.001, 3.004, "0.00"), (12.5, 0.0, "12.50")],
)
def test_a_difference_is_that_of_the_times_that_are_shown(open_page, time, earlier, shown):
    tab = open_page()
    code = """async ([time, earlier]) => {
        const { difference, short } = await import("./timeline.js");
        return [difference(time, earlier), short(time), short(earlier)];
    }"""
    difference, one, other = tab.evaluate(code, [time, earlier])
    assert difference == shown
    assert float(difference) == pytest.approx(max(float(one) - float(other), 0.0))


@pytest.mark.parametrize("size", [(1280, 800), (1024, 560), (400, 800), (360, 640)])
@pytest.mark.parametrize("query", ["?start=fig3", "?evaders=8&seed=2", "?evaders=1&seed=1"])
def test_everybody_is_in_sight_at_the_start(open_page, size, query):
    tab = open_page(query, viewport={"width": size[0], "height": size[1]})
    tab.page.wait_for_timeout(100)
    picture = tab.heard["game"]["picture"]
    code = """([x, y]) => {
        const [left, top] = document.getElementById("board").camera.toScreen(x, y);
        return document.elementFromPoint(left, top)?.id;
    }"""
    for x, y, *_ in [*picture["evaders"], picture["pursuer"]]:
        assert tab.evaluate(code, [x, y]) == "board"


@pytest.mark.parametrize("width", [1280, 400, 360])
def test_words_on_the_line_of_time_do_not_touch(open_page, width):
    tab = open_page("?start=fig3&sensing=hidden", viewport={"width": width, "height": 800})
    tab.wait(lambda: "reference" in tab.heard)
    tab.see("best known")
    words = [each.bounding_box() for each in tab.page.locator(".mark span").all()]
    assert len(words) == 2
    first, second = sorted(words, key=lambda box: box["x"])
    beside = second["x"] >= first["x"] + first["width"] + 4
    below = second["y"] >= first["y"] + first["height"]
    assert beside or below
    assert all(box["x"] >= 0 and box["x"] + box["width"] <= width for box in words)


def test_a_legend_names_the_signs_that_are_on_the_board(open_page):
    tab = open_page("?start=fig3&sensing=visible")

    def named():
        shown = tab.page.get_by_label("Signs on the board").locator("li:visible").all()
        return [item.inner_text().split("\n")[-1] for item in shown]

    always = ["evader with its number", "you, the pursuer", "captured"]
    beliefs = ["expected capture", "planned path", "expected pursuit"]
    assert named() == always + beliefs
    tab.page.get_by_role("switch").uncheck()
    assert named() == always
    hidden = open_page("?start=fig3&sensing=hidden").page.get_by_label("Signs on the board")
    hidden.get_by_text("where you may be").wait_for()


@pytest.mark.parametrize(("width", "height"), [(1000, 800), (1300, 500), (400, 800)])
def test_the_legend_stands_with_the_choices_where_the_board_is_small(open_page, width, height):
    tab = open_page("?start=fig3", viewport={"width": width, "height": height})
    legend = tab.page.get_by_label("Signs on the board")
    legend.scroll_into_view_if_needed()
    assert legend.locator("li:visible").count() == 6
    (box, board) = (tab.page.locator(each).bounding_box() for each in (".legend", "#board"))
    assert box["x"] >= board["x"] + board["width"] or box["y"] >= board["y"] + board["height"]


def test_a_record_is_shown_with_its_units(open_page, tmp_path):
    team = covey.Team([(900.0, 300.0), (-200.0, 700.0)], 0.3, 20.0, turn_radii=60.0, unit="m")
    game = covey.simulate(team, covey.PursuerDisk(speed=45.0, unit="m"), update_time=1.0)
    covey.save_game(game, tmp_path / "game.parquet")
    tab = open_page("?start=fig3")
    legend = tab.page.get_by_label("Signs on the board")
    assert not legend.get_by_text("wide").is_visible()
    tab.page.locator("#open").set_input_files(tmp_path / "game.parquet")
    tab.page.locator("#clock", has_text=" s").wait_for()
    assert tab.page.locator(".mark.guaranteed").inner_text().endswith(f" {game.guarantee:.2f} s")
    assert re.fullmatch(r"[125]0* m wide", legend.get_by_text("wide").inner_text())
