"""Faults: what happens to a user's runs from outside, at random moments from one seed.

A process is killed, stopped or interrupted, a disk is full, a file is cut, two runs meet. After
each, either the result is byte for byte that of an undisturbed run, or one clear line said why not.
`python -m faults --help` tells how to run them; `make faults` runs all.

Read `outcome` (what a run may end with), `processes` (runs and signals), `study` (the study that is
disturbed, and what its result must be), then the faults: `kills`, `interrupts`, `disks`, `cuts`,
`company`, `kernel_cache`. `catalogue` lists them.
"""
