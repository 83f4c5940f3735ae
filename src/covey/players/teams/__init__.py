"""Strategies of the evaders.

Read `open_loop` first (the paper's, section IV), then `replan_interval`, and `simple` and
`lookahead` with the teams of the references built on them.
"""
