"""Fuzzing: inputs that nobody would write, and what covey must still keep.

`python -m fuzz` searches, `python -m fuzz FILE` repeats a case. A case is the content of one file:
a scenario, a study, a record, a folder of results, the messages of a page, or a call of the public
API. So a case means the same, whatever drew it. Read `target` (what a target is), `oracle` (what
must hold), one target, for example `scenarios`, and `search` (one worker); `watch` runs them all.
"""
