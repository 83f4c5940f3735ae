"""The paper's Figs. 1 and 2, and charts of studies.

Read `single_turn`, then `control` (Fig. 1) and `capture` (Fig. 2), which share it. The charts of
studies stand alone: `ratios` (Fig. 4), `gains` (Fig. 5), `comparison`, `closeness`.
"""
