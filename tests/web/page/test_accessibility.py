"""The page fits phones and what its reader prefers, and has a name for everything."""

from __future__ import annotations

import re

from web.browser_pages import BOARD, colours


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
