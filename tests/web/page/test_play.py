"""Games in a real browser: played, saved, replayed, opened."""

from __future__ import annotations

import json

import pytest

import covey
from covey.cli import main
from covey.web.game.human_game import UPDATE_TIME
from web.browser_pages import BOARD, CAPTURED, Tab, colours


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


def test_the_page_says_when_the_server_is_gone(browser):
    from web.served_pages import serving

    with serving() as served:
        tab = Tab(browser, f"{served.address}/?evaders=1")
        tab.see("Press on the board to start")
    tab.see("The server is gone")
    tab.context.close()
