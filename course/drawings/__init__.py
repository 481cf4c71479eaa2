"""Explanatory drawings, one module for each notebook: each function returns a Picture with alt text, in the reader's language.

In these drawings the unit of length is the robot's tread, angles are in degrees, and points are complex numbers.
"""
