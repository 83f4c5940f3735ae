"""The paper's Figs. 4 and 5 as numbers, and a report that compares them with its claims.

Read in this order: `figures`, `claims`, `report`.
"""
