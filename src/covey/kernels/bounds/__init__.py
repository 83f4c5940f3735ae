"""What no team can exceed: latest last captures in known sequences, and one small game's value.

Read `fixed_sequence`, `announced_sequences`, then `corner_programme`, `mixture` and
`mixture_bound`. `two_evaders` stands alone.
"""
