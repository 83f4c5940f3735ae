"""`covey chase`: the server starts, says where it is, and ends as it should."""

from __future__ import annotations

import importlib.util
import os
import re
import signal
import socket
import subprocess
import sys
import time
import urllib.request

import pytest

from covey.cli import main


def test_without_the_extra_it_says_what_to_install(monkeypatch, capsys):
    find = importlib.util.find_spec
    monkeypatch.setattr(
        importlib.util, "find_spec", lambda name: None if name == "uvicorn" else find(name)
    )
    assert main(["chase"]) == 2
    said = capsys.readouterr().err
    assert said == (
        "covey: covey chase needs uvicorn, which comes with the extra `web`: "
        "pip install 'covey[web]'\n"
    )


@pytest.mark.parametrize("port", ["-1", "65536"])
def test_a_port_that_is_none_is_a_mistake(port, capsys):
    assert main(["chase", "--no-browser", "--port", port]) == 2
    assert "--port: expected a whole number from 0 to 65535" in capsys.readouterr().err


def test_a_port_that_is_taken_is_a_mistake(capsys):
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = taken.getsockname()[1]
        assert main(["chase", "--no-browser", "--port", str(port)]) == 2
    assert f"can't listen on 127.0.0.1, port {port}" in capsys.readouterr().err


@pytest.mark.skipif(sys.platform == "win32", reason="no shell script can be the browser there")
def test_it_opens_the_page_serves_it_and_ends_with_ctrl_c(tmp_path):
    opened = tmp_path / "opened"
    browser = tmp_path / "browser"
    browser.write_text(f'#!/bin/sh\necho "$1" > {opened}\n')
    browser.chmod(0o755)
    with subprocess.Popen(
        [sys.executable, "-m", "covey", "chase", "--port", "0"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env={**os.environ, "BROWSER": str(browser)},
    ) as process:
        address = re.search(r"http://127\.0\.0\.1:\d+/", process.stdout.readline())[0]
        ends = time.monotonic() + 20.0
        while not opened.exists() or not opened.read_text():
            assert time.monotonic() < ends
            time.sleep(0.05)
        assert opened.read_text() == address + "\n"
        with urllib.request.urlopen(address, timeout=10) as page:
            assert b"covey chase" in page.read()
        process.send_signal(signal.SIGINT)
        _, said = process.communicate(timeout=20)
    assert process.returncode == 0
    assert "covey: stopped" in said.splitlines()
    assert "Traceback" not in said
