"""Strategies of the evaders."""
