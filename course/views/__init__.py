"""Views to play with, one module for each notebook: sliders that redraw a picture, and films."""
