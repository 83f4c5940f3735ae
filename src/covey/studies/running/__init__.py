"""Playing the games of a study: chunks, executors, tables, resuming."""
