"""Means and ratios of the games of a study, and the yardstick for games of two evaders.

Read in this order: `summary`, `paired_ratios`, `tournament`, `objectives`, `comparison`,
`yardstick`.
"""
