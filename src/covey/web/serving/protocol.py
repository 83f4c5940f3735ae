"""uvicorn's WebSocket connection, with two limits that its settings don't have."""

from __future__ import annotations

import logging
import time
from typing import Any

from uvicorn.protocols.websockets.websockets_sansio_impl import WebSocketsSansIOProtocol

from covey.web.serving.rate_limit import TokenBucket

_SHARE, _BURST = 0.1, 0.5
"""Of the network thread's processor time that one page may take, and seconds that it may save up.

A page that steers takes 1 %, and a record of 16 MiB some 0.05 s.
"""

_logger = logging.getLogger("uvicorn.error")


class LimitedProtocol(WebSocketsSansIOProtocol):
    """Closes connections that take too much time, or that don't read.

    uvicorn stops reading when a message waits for the application. Pings and fragments are no
    messages, so that a flood of them would leave the thread no time for other pages.
    """

    def __init__(self, *arguments: Any, **options: Any) -> None:
        super().__init__(*arguments, **options)
        self._time = TokenBucket(_SHARE, _BURST)

    def data_received(self, data: bytes) -> None:
        """Read, and count the processor's time: waiting for a busy machine is no flood."""
        began = time.thread_time()
        super().data_received(data)
        spent = time.thread_time() - began
        if not self._time.take(time.monotonic(), spent) and not self.transport.is_closing():
            _logger.warning("A page was closed: it sent more than can be read.")
            self.transport.abort()

    def keepalive_timeout(self) -> None:
        """Close a connection that doesn't answer, and drop what it hasn't read."""
        super().keepalive_timeout()
        self.transport.abort()  # closing would wait until all is read
