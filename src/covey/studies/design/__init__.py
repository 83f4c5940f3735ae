"""What a study is: its grid of cases, its starts, its file.

Read case and study first, then fields and consistency (what its values may be) and study_file. start_table
and as_visible are two of those values: starts from a table, and the pursuer of Fig. 4.
"""
