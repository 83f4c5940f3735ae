"""The page in a real browser: whole games, what is shown, and that nothing goes wrong."""

from __future__ import annotations

import io
import json
import re

import numpy as np
import pytest
from PIL import Image

import covey
from covey.cli import main
from covey.web.human_game import UPDATE_TIME
from web.browser_pages import NAMES, Tab, chromium, found

if found() is None:
    pytest.skip(
        f"no Chromium here ({', '.join(NAMES)}): the page is not tested in a browser",
        allow_module_level=True,
    )

TEAM, CAPTURED, BOARD = (0, 114, 178), (194, 78, 0), (251, 250, 247)
"""Colours of the light page."""


@pytest.fixture(scope="module")
def browser():
    with chromium() as started:
        yield started


@pytest.fixture
def open_page(server, browser):
    """Opens pages; in the end none of them may have had trouble, or asked anybody else."""
    tabs = []

    def opened(query="", **options):
        tab = Tab(browser, f"{server.address}/{query}", **options)
        tabs.append(tab)
        tab.see("Press on the board to start")
        return tab

    yield opened
    for tab in tabs:
        assert tab.troubles == []
        own = (server.address, f"blob:{server.address}")
        assert [url for url in tab.requests if not url.startswith(own)] == []
        tab.context.close()


def colours(tab):
    """The picture on the screen, and how many of its pixels have nearly a colour."""
    picture = np.asarray(Image.open(io.BytesIO(tab.page.screenshot())).convert("RGB"), int)

    def count(colour, of=picture):
        return int((np.abs(of - np.array(colour)).max(axis=2) < 12).sum())

    return picture, count


@pytest.mark.parametrize("sensing", ["visible", "hidden"])
def test_a_whole_game_is_played_scored_saved_and_replayed(open_page, sensing, tmp_path):
    tab = open_page(f"?evaders=3&seed=4&capture_radius=0.08&sensing={sensing}")
    tab.set_pace("1")
    score = tab.chase()
    tab.see("as quick as the best pursuer known")

    with tab.page.expect_download() as download:
        tab.page.get_by_role("button", name="Save record").click()
    path = tmp_path / "game.parquet"
    download.value.save_as(path)
    game = covey.load_game(path)
    assert (game.sensing, game.strategies["pursuer"]) == (sensing, {"name": "person"})
    assert sorted(game.capture_sequence) == [0, 1, 2]
    reference = min(
        covey.simulate(
            game.team,
            game.disk,
            pursuer=pursuer,
            sensing=sensing,
            update_time=UPDATE_TIME,
            seed=4,
        ).survival_time
        for pursuer in (covey.CommittedPursuer(), covey.BestSequence())
    )
    assert score["time"] == game.survival_time >= game.guarantee - 1e-9

    # The score is the person against the best pursuer known.
    share = reference / game.survival_time
    assert tab.text("card-score") == f"{round(100 * share)} %"
    figures = tab.text("card-figures").split("\n")
    assured = covey.bracket(game.team, game.disk, seed=4).upper
    times = game.survival_time, reference, game.guarantee, assured
    assert figures[1::2] == [f"{time:.2f}" for time in times]
    shown_difference = round(game.survival_time, 2) - round(game.guarantee, 2)
    assert f"{shown_difference:.2f} above" in tab.text("card-text")
    tab.wait(lambda: tab.text("clock") == f"{game.survival_time:.2f}")
    assert (
        tab.text("best")
        == f"{round(100 * share)} %\n3 {sensing}, random 4\n{game.survival_time:.2f}"
    )
    kept = json.loads(tab.evaluate("localStorage.getItem('covey-chase-results')"))
    assert kept[0]["share"] == pytest.approx(share)

    # The picture: trails of the team, three captures, and mostly an empty board.
    picture, count = colours(tab)
    assert count(CAPTURED) > 300
    assert count(BOARD) > 0.3 * picture.shape[0] * picture.shape[1]

    tab.page.get_by_role("button", name="Replay yours").click()
    tab.see("replay of your game")
    tab.wait(lambda: float(tab.text("clock")) > 0.3)
    tab.page.get_by_role("button", name="Back to your game").click()
    tab.see("as quick as the best pursuer known")
    tab.page.get_by_role("button", name="Play again").click()
    tab.see("Press on the board to start")


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
@pytest.mark.parametrize("query", ["?start=fig3", "?evaders=10&seed=2", "?evaders=1&seed=1"])
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


def test_keys_start_steer_pause_and_step(open_page):
    tab = open_page("?evaders=2&seed=3&capture_radius=0.01")
    keys = tab.page.keyboard
    tab.page.get_by_role("button", name="Start", exact=True).focus()
    keys.press("Space")
    tab.wait(lambda: "frame" in tab.heard)
    keys.down("ArrowUp")
    tab.wait(lambda: tab.heard["frame"]["pursuer"][1] > 0.02)
    assert tab.heard["frame"]["pursuer"][0] == pytest.approx(0.0, abs=1e-9)
    keys.down("KeyD")
    tab.wait(lambda: tab.heard["frame"]["pursuer"][0] > 0.02)
    keys.up("KeyD")
    keys.up("ArrowUp")
    keys.press("Space")
    tab.wait(lambda: tab.page.get_by_role("button", name="Go on").is_visible())
    tab.page.wait_for_timeout(100)
    time = tab.heard["frame"]["time"]
    tab.page.wait_for_timeout(200)
    assert tab.heard["frame"]["time"] == time
    keys.press("Period")
    tab.wait(lambda: tab.heard["frame"]["time"] == pytest.approx(time + 0.05))
    tab.wait(lambda: tab.text("clock") == f"{tab.heard['frame']['time']:.2f}")


def test_the_address_is_the_game(open_page):
    query = "?evaders=4&speed=0.3&pursuer_speed=1.2&turn_rate=3&capture_radius=0.05&sensing=hidden"
    query += "&team=open-loop&start=formation&seed=77"
    one, other = open_page(query), open_page(query)
    assert one.heard["game"] == other.heard["game"]
    assert one.heard["game"]["choices"] == {
        "evaders": 4,
        "speed": 0.3,
        "pursuer_speed": 1.2,
        "turn_rate": 3.0,
        "capture_radius": 0.05,
        "sensing": "hidden",
        "team": "open-loop",
        "start": "formation",
        "seed": 77,
    }
    # What is chosen anew stands in the address, and a page that is opened there plays it.
    one.page.get_by_role("radio", name="Visible").click()
    one.wait(lambda: one.heard["game"]["choices"]["sensing"] == "visible")
    address = one.page.url
    assert "sensing=visible" in address
    third = open_page(address[address.index("?") :])
    assert third.heard["game"] == one.heard["game"]


def test_another_start_is_another_one_also_after_fig3(open_page):
    tab = open_page("?start=fig3&seed=5")
    tab.page.get_by_role("button", name="Another start").click()
    tab.wait(lambda: tab.heard["game"]["choices"]["start"] == "random")
    before = tab.heard["game"]["picture"]["evaders"]
    tab.page.keyboard.press("n")
    tab.wait(lambda: tab.heard["game"]["picture"]["evaders"] != before)
    tab.see("Press on the board to start")


def test_a_team_that_answers_captures_has_at_most_eight_evaders(open_page):
    tab = open_page("?team=contingent&evaders=10&capture_radius=0.1")
    assert tab.heard["game"]["choices"]["evaders"] == 8
    tab.page.get_by_role("combobox", name="The team").select_option("open-loop")
    tab.wait(lambda: tab.heard["game"]["choices"]["team"] == "open-loop")
    slider = tab.page.get_by_role("slider", name="Evaders")
    assert slider.get_attribute("max") == "10"


def test_nonsense_in_the_address_is_answered(browser, server):
    tab = Tab(browser, f"{server.address}/?evaders=3&seed=99999999999&colour=red")
    tab.see("seed")
    tab.see("This game can't be played")
    tab.page.get_by_role("button", name="Another start").click()
    tab.see("Press on the board to start")
    tab.context.close()


def test_the_best_pursuer_plays_the_same_start(open_page):
    tab = open_page("?evaders=2&seed=3")
    tab.set_pace("2")
    tab.page.get_by_role("button", name="Watch the best pursuer").click()
    tab.wait(lambda: "film" in tab.heard)
    film = tab.heard["film"]
    assert film["pictures"][0]["evaders"] == tab.heard["game"]["picture"]["evaders"]
    assert film["survival_time"] == tab.heard["reference"]["survival_time"]
    tab.see(f"The last was captured at {film['survival_time']:.2f}.")
    # Any moment can be gone back to.
    tab.page.get_by_label("Moment of the game").fill("0.25")
    tab.wait(lambda: tab.text("clock") == "0.25")
    tab.page.get_by_role("button", name="One step").click()
    tab.wait(lambda: tab.text("clock") == "0.30")


def test_a_record_of_simulate_is_opened_and_what_is_none_refused(open_page, tmp_path):
    path = tmp_path / "game.parquet"
    assert main(["simulate", "fig3", "-o", str(path)]) == 0
    tab = open_page("?evaders=2&seed=3")
    tab.page.locator("#open").set_input_files(path)
    tab.wait(lambda: "film" in tab.heard)
    game = covey.load_game(path)
    assert tab.heard["film"]["survival_time"] == game.survival_time
    tab.wait(lambda: tab.text("left-chip").endswith("of 5 alive"))
    path.write_bytes(b"PAR1 and nothing else")
    tab.page.locator("#open").set_input_files(path)
    tab.see("damaged or cut off")
    tab.page.get_by_role("button", name="Back to your game").click()
    tab.see("Press on the board to start")


def test_a_phone(open_page):
    tab = open_page(
        "?evaders=3&seed=3&sensing=hidden",
        viewport={"width": 390, "height": 844},
        device_scale_factor=2,
        has_touch=True,
        is_mobile=True,
    )
    assert tab.evaluate("document.documentElement.scrollWidth") == 390
    for name in ("board", "play", "clock"):
        box = tab.page.locator(f"#{name}").bounding_box()
        assert box["x"] >= 0
        assert box["x"] + box["width"] <= 390
        assert box["y"] + box["height"] <= 844
    tab.page.touchscreen.tap(300, 300)
    tab.wait(lambda: "frame" in tab.heard and tab.heard["frame"]["pursuer"][0] > 0.01)
    assert tab.page.locator("#card").is_hidden()


def test_light_and_dark(open_page):
    dark = open_page("?evaders=1", color_scheme="dark")
    _, count = colours(dark)
    assert count(BOARD) < 1000
    dark.page.get_by_role("button", name="Light or dark").click()
    dark.page.wait_for_timeout(100)
    _, count = colours(dark)
    assert count(BOARD) > 100_000
    dark.page.reload()
    dark.see("Press on the board to start")
    assert dark.evaluate("document.documentElement.dataset.theme") == "light"


def test_reduced_motion_keeps_the_view_still(open_page):
    tab = open_page("?evaders=4&seed=3&capture_radius=0.01", reduced_motion="reduce")
    view = "JSON.stringify(Object.entries(document.getElementById('board').camera))"
    before = tab.evaluate(view)
    tab.page.keyboard.press("Space")
    tab.wait(lambda: tab.heard.get("frame", {"time": 0})["time"] > 0.2)
    assert tab.evaluate(view) == before


def test_everything_has_a_name_for_those_who_cannot_see(open_page):
    tab = open_page()
    tree = tab.page.locator("body").aria_snapshot()
    kinds = "button|slider|combobox|spinbutton|radio|switch|checkbox|application"
    assert len(re.findall(rf"- ({kinds}) \"", tree)) > 20
    assert re.findall(rf"- (?:{kinds})(?! \").*", tree) == []
    assert "sure to survive" in tab.text("said")


def test_the_page_says_when_the_server_is_gone(browser):
    from web.served_pages import serving

    with serving() as served:
        tab = Tab(browser, f"{served.address}/?evaders=1")
        tab.see("Press on the board to start")
    tab.see("The server is gone")
    tab.context.close()
