"""Files that are complete or unchanged."""

from __future__ import annotations

import os
import secrets


def _replace_file(path: str | os.PathLike[str], data: bytes) -> None:
    """Writes a file beside `path` and renames it, so that an older file stays until the new one is complete."""
    name = os.fspath(path)
    temporary = f"{name}.{secrets.token_hex(8)}.part"
    file = os.open(temporary, os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_CLOEXEC", 0), 0o666)
    try:
        with open(file, "wb") as stream:
            stream.write(data)
            stream.flush()
            os.fsync(stream.fileno())
        os.replace(temporary, name)
    except BaseException:
        os.remove(temporary)
        raise
    folder = os.open(os.path.dirname(name) or ".", os.O_RDONLY)
    try:
        os.fsync(folder)
    except OSError:  # some file systems have no such operation; the file is complete
        pass
    finally:
        os.close(folder)
