"""The page on which a person plays the pursuer against a team that plans as it flies."""
