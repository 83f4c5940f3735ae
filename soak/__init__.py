"""A soak: random games of all players, played for hours, each checked against the rules.

`python -m soak` plays. One seed settles one game and what is checked of it. Read `case` (what is
drawn), `legal_game` and `trial` (what is checked), `workers` and `totals` (how many games become a
figure), and `answers` for teams that answer captures alone.
"""
