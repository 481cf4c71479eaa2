"""The seeds of the cases: secret, different for every student and attempt, and the same again for an appeal."""

import contextlib
import hashlib
import hmac
import os
import secrets
from pathlib import Path

_SECRET_BYTES = 32


class SecretError(RuntimeError):
    """The course's secret cannot be used; the message says what to do."""


def course_secret(folder: Path) -> bytes:
    """Return the secret of the course, kept in a file below `folder` that only its owner reads; made when it is not there."""
    path = folder / "secret"
    with contextlib.suppress(FileExistsError):
        _write_new(path, secrets.token_bytes(_SECRET_BYTES))
    secret = path.read_bytes()
    if len(secret) != _SECRET_BYTES:
        raise SecretError(
            f"{path} is damaged. Put it back from a backup; if there is none, remove it, and the cases are drawn anew."
        )
    return secret


def exercise_seed(secret: bytes, student: str, assignment: str, exercise: str, attempt: int) -> int:
    """Return the seed (63 bits) from which the cases of one exercise are drawn for one student's attempt (1 is the first)."""
    # lengths first: no two different rows of names give the same message
    parts = (part.encode(errors="surrogateescape") for part in (student, assignment, exercise, str(attempt)))
    message = b"".join(len(part).to_bytes(4, "big") + part for part in parts)
    return int.from_bytes(hmac.new(secret, message, hashlib.sha256).digest()[:8], "big") >> 1


def _write_new(path: Path, content: bytes) -> None:
    """Write a file that must not be there yet, whole or not at all."""
    if path.exists():
        raise FileExistsError(path)
    made = path.with_name(f"{path.name}.{os.getpid()}")
    descriptor = os.open(made, os.O_WRONLY | os.O_CREAT | os.O_TRUNC | os.O_NOFOLLOW, 0o600)
    try:
        with os.fdopen(descriptor, "wb") as file:
            file.write(content)
        # of two that begin at the same time one wins, and both use its secret
        os.link(made, path)
    finally:
        made.unlink()
