"""Plays the games of a study and stores them, so that a run can be stopped and resumed.

Read in this order: `run`, `chunks`, `scheduler`, `executors`, `worker`, `games`, `tables`,
`parts`, `result_files`, `lock`, `manifest`, `provenance`, `results`.
"""
