"""What commands share before they print.

Read `arguments` (options of several commands), `sources` (what FILE may be), `outputs` (files to
be written), `exit_status`, and `waiting` (what a terminal shows meanwhile).
"""
