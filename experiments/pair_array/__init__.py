"""A covering array of small scenes, in which each pair of values of two features stands: see experiments/pairs.py."""
