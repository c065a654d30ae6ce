"""The settings of operations: what there is, and what the user sees them called."""
