"""A real Chromium, driven by Playwright, and a player who chases by moving its mouse."""

from __future__ import annotations

import io
import json
import shutil
from contextlib import contextmanager

import numpy as np
from PIL import Image

from web.chase_pages import aim

ARGUMENTS = [
    "--headless=new",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
]

NAMES = ("chromium", "chromium-browser", "google-chrome")


TEAM, CAPTURED, BOARD = (0, 114, 178), (194, 78, 0), (251, 250, 247)
"""Colours of the light page."""


def found():
    """The path of a Chromium, or None."""
    return next((path for name in NAMES if (path := shutil.which(name))), None)


@contextmanager
def chromium():
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=found(), args=ARGUMENTS)
        yield browser
        browser.close()


class Tab:
    """A page with what it said and heard."""

    def __init__(self, browser, address, **options):
        options.setdefault("viewport", {"width": 1280, "height": 800})
        self.context = browser.new_context(**options)
        self.page = self.context.new_page()
        self.page.set_default_timeout(20_000)
        self.troubles, self.requests, self.heard = [], [], {}
        self.page.on("console", self._console)
        self.page.on("pageerror", lambda error: self.troubles.append(str(error)))
        self.page.on("request", lambda request: self.requests.append(request.url))
        self.page.on("websocket", lambda socket: socket.on("framereceived", self._hear))
        self.page.goto(address)

    def _console(self, message):
        if message.type in {"error", "warning"}:
            self.troubles.append(message.text)

    def _hear(self, content):
        if isinstance(content, str):
            message = json.loads(content)
            self.heard[message["type"]] = message

    def see(self, text):
        self.page.get_by_text(text).first.wait_for()

    def text(self, name):
        return self.page.locator(f"#{name}").inner_text()

    def evaluate(self, code, argument=None):
        return self.page.evaluate(code, argument)

    def wait(self, condition, tries=500):
        for _ in range(tries):
            if condition():
                return
            self.page.wait_for_timeout(20)
        raise AssertionError("waited in vain")

    def set_pace(self, pace):
        self.page.locator("#pace").select_option(pace)

    def place_of(self, x, y):
        """Where a place of the game is on the screen."""
        return self.evaluate(
            "([x, y]) => document.getElementById('board').camera.toScreen(x, y)", [x, y]
        )

    def chase(self):
        """Play the game that is ready to its end, with the mouse; return the score that came."""
        self.heard.pop("over", None)
        self.heard.pop("frame", None)
        self.page.mouse.click(500, 300)
        cast = self.heard["game"]["cast"]
        for _ in range(2000):
            if "over" in self.heard:
                return self.heard["over"]
            frame = self.heard.get("frame")
            if frame and frame["sequence"]:
                self.page.mouse.move(*self.place_of(*aim(frame, cast)))
            self.page.wait_for_timeout(10)
        raise AssertionError("the game didn't end")


def colours(tab):
    """The picture on the screen, and how many of its pixels have nearly a colour."""
    picture = np.asarray(Image.open(io.BytesIO(tab.page.screenshot())).convert("RGB"), int)

    def count(colour, of=picture):
        return int((np.abs(of - np.array(colour)).max(axis=2) < 12).sum())

    return picture, count
