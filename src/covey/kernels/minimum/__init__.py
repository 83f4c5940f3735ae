"""The inner half of eq. 6: the minimum over all capture sequences."""
