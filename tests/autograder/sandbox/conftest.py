"""One notebook's process without a sandbox around it: what runs inside is the same."""

import pytest

from autograder.session import Limits, Session


@pytest.fixture(scope="package")
def session():
    with Session(Limits(cell=2.0, check=2.0), sandbox=False) as opened:
        yield opened
