"""What a study is: its grid of cases, its starts, its file.

Read `case` and `study` first, then `fields` and `consistency` (what a study's values may be) and
`study_file`. `samplers`, `start_table` and `as_visible` are such values.
"""
