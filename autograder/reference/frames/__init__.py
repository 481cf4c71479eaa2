"""Exercises of notebook 4: poses between frames, the frames of YP-Spur, and compass headings (notes 001, sections 2-3; slides 003)."""
