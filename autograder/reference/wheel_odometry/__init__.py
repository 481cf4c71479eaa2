"""Exercises of notebook 5: the program of the practical and its three graphs (slides 000, practical training with wheel odometry)."""
