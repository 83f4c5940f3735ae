"""What a study is: its grid of cases, its starts, its file."""
