"""Exercises of notebook 2: from encoder counts to wheel speeds and the velocity of the body (slides 000, overview 5-6; notes 001, eq. 4-5)."""
