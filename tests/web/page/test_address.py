"""The address of the page and its buttons choose the game."""

from __future__ import annotations

from web.browser_pages import Tab


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
