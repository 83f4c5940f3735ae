"""How pages are served: the page's files, and a WebSocket for each page.

Read `connection` (a page's requests and replies), `app`, `protocol` and `server`. What keeps one
page from another's game: `fair_queue` and `fair_threads` (whose turn it is), `admission`,
`rate_limit` and `origin` (what comes in).
"""
