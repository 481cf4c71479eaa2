"""nbgrader's settings for this course; its root is the directory of this file.

nbgrader runs a program of its own, alembic, when it makes a gradebook: put .venv/bin on PATH (`source .venv/bin/activate`).
"""

c = get_config()  # noqa: F821 - nbgrader puts it here

c.CourseDirectory.course_id = "dead-reckoning"
# nbgrader knows one release; `autograder build` makes one for each language. The exchange hands out this one.
c.CourseDirectory.release_directory = "release/ja"
# nbgrader copies what lies beside a notebook to the students: the sources (*.md) hold the solutions
# (.new-*: what a run that was killed left of a file)
c.CourseDirectory.ignore = [".ipynb_checkpoints", "*.pyc", "__pycache__", "feedback", "*.md", ".new-*"]
# a written answer starts empty, the same in both languages
c.ClearSolutions.text_stub = ""
# `nbgrader autograde` and formgrader's Autograde button run the course's own grader. For nbgrader's own, without a sandbox, remove
# this line, or type: nbgrader autograde ASSIGNMENT --Autograde.exporter_class=nbconvert.exporters.NotebookExporter
c.Autograde.exporter_class = "autograder.plugin.GradingExporter"
