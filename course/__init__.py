"""What students import: logs, robots, drawings, views, and the check after each exercise.

A notebook begins with `from course.en import check` or `from course.ja import check`. Importing `course` itself costs next to nothing.
"""
