"""`autograder grade`, with limits that are short enough for tests."""

from functools import partial

from autograder import cli
from autograder.engine import Options
from autograder.session import Limits

#: the loop ends soon, and honest answers have time enough on a machine that does other things as well
LIMITS = Limits(cell=20.0, check=3.0, notebook=90.0, grace=5.0)

if __name__ == "__main__":
    cli.Options = partial(Options, limits=LIMITS)
    cli.app()
