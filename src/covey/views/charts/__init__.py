"""Charts of studies, and the paper's Figs. 1 and 2."""
