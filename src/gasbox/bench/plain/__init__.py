"""Plain engines, as a textbook has them: the yardstick for the fast ones. Each stands in one file by itself."""
