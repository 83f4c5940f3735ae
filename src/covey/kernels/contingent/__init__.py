"""Contingent plans: a tree of turns that answers each capture, its exact value, its local maxima.

Read `tree`, `branch` (Algorithm 1 along one capture sequence), `derivatives`, `minimum` (over all
sequences), `local_model`, then `ascent`. `delays` is about captures that are put off.
"""
