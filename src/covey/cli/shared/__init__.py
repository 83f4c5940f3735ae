"""What several commands share: arguments, sources, outputs."""
