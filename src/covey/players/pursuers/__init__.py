"""Strategies of the pursuer."""
