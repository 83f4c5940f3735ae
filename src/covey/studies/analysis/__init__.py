"""What the games of a study say."""
