"""The same minimum for teams too large for a table of all sets.

Walks may visit an evader twice and skip another; the least walk is a lower bound. `neighbours` says
which evaders a walk remembers, `walks` finds the least walk, `weights` makes it skip and repeat
less, `tours` turns it into a sequence, an upper bound. `completions` runs walks backwards from the
upper bound, which leaves few labels to `search`, the exact forward programme. `minimum` is all of
it.
"""
