"""The capture of evaders on given paths: eq. 5, eq. 7 and Algorithm 1 of the paper."""
