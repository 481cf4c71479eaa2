"""The sandbox's side: all of the autograder that student code ever shares a machine view with.

It imports the standard library, IPython and `course` only, and knows no exercise.
"""
