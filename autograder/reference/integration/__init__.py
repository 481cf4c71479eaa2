"""Exercises of notebook 3: numerical integration, Euler and the trapezoid rule, on functions, samples and poses (slides 003)."""
