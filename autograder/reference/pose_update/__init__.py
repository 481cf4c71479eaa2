"""Exercises of notebook 1: how one step moves a pose (slides 000, overview 1-4; notes 001, section 1)."""
