"""The subcommands of `covey`, a file each, imported when the command or its help is asked for.

Read `plan` (what every command does: load, compute, print), then `simulate` and `worst_case`.
`draw` makes pictures, `study`, `reproduce` and `yardstick` play many games, `chase` serves a page,
`notebook` runs a notebook.
"""
