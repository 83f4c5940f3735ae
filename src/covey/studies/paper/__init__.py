"""The paper's Figs. 3 to 5 as numbers, and what it claims about them."""
