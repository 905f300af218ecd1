"""Judges a folder and the messages after a run that met a fault."""
import dataclasses
import json
import os
import pathlib
import re
import shutil

from . import validate

BAD_WORDS = ("Aborted", "terminate", "Segmentation", "std::", "what()", "Assertion", "core dumped", "filesystem error",
             "basic_ios", "bad_alloc", "iostream", "Sanitizer")  # fmt: skip
TEMPORARY = re.compile(r"\.(partial|probe|part|tmp|temp)\b")

RESCUED = re.compile(r"dsc_failed.*\.dsc")  # what a run saves whose folder is lost


def snapshot(folder):
    """Returns the contents of files, targets of links, and None for folders, by relative paths."""
    result = {}
    for parent, folders, files in os.walk(folder):
        for name in folders + files:
            path = os.path.join(parent, name)
            place = os.path.relpath(path, folder)
            if os.path.islink(path):
                result[place] = ("link", os.readlink(path))
            elif os.path.isdir(path):
                result[place] = None
            else:
                result[place] = pathlib.Path(path).read_bytes()
    return result


def restore(state, folder):
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    for place, content in sorted(state.items()):
        path = os.path.join(folder, place)
        if content is None:
            os.makedirs(path, exist_ok=True)
        else:
            os.makedirs(os.path.dirname(path), exist_ok=True)
            pathlib.Path(path).write_bytes(content)


def _lists(place, data):
    """Returns the paths that a collection lists."""
    return [os.path.normpath(os.path.join(os.path.dirname(place), f)) for f in validate.files_of_collection(data)]


def faults_of_files(old, new, now, *, results=(), complete=None, killed=False, ignored=()):
    """Returns what is wrong with the files `now`: each must have its content of `old`, of `new`, or another whole
    content. Files not in `results` may not change. If the run was complete, all files of
    `new` must exist, those named in `complete` with this content."""
    faults = []
    for place in sorted(set(old) | set(now)):
        if any(place == name or place.startswith(name + "/") for name in ignored):
            continue
        content = now.get(place)
        if place not in now:
            faults.append(("an older file is lost", place))
        elif place not in old and place not in new:
            if RESCUED.fullmatch(place):
                if fault := validate.fault_of(place, content):
                    faults.append(("a file is not whole", f"{place} {fault}"))
            elif not killed:
                faults.append(("a temporary file is left", place))
        elif isinstance(content, tuple):
            faults.append(("a result is a link", place))
        elif content is not None and content != old.get(place) and content != new.get(place):
            if place in old and place not in results:
                faults.append(("an input is changed", place))
            elif fault := validate.fault_of(place, content):
                faults.append(("a file is not whole", f"{place} {fault}"))
        if content and place.endswith((".pvd", ".pvtu")) and not validate.fault_of(place, content):
            for listed in _lists(place, content):
                if listed not in now:
                    faults.append(("a collection lists a missing file", f"{place}: {listed}"))
    if complete is not None:
        for place, content in new.items():
            if place not in now:
                faults.append(("status 0, but a result is missing", place))
            elif content != old.get(place) and now[place] == old.get(place):
                faults.append(("status 0, but a result is the older one", place))
            elif place in complete and now[place] != content:
                faults.append(("status 0, but a result is not that of an undisturbed run", place))
    return faults


def faults_of_messages(outcome, *, names=(), temporary=(), elsewhere="", python=False, prefixed=False):
    """Returns what is wrong with the status and the messages. `names` are files that the user knows; `elsewhere` is
    the folder of temporary files."""
    faults = []
    lines = [line for line in outcome.err.splitlines() if line.strip()]
    own = [line for line in lines if line.startswith("dsc: ")]
    if outcome.status == "hangs":
        return [("the run hangs", "")]
    if outcome.status < 0 or outcome.status > 128:
        faults.append(("the run is killed by a signal", f"status {outcome.status}: {outcome.err[-200:]}"))
    if outcome.status != 0 and not python:
        if len(own) != 1 or (len(lines) != 1 and not prefixed):
            kind = "no line" if not lines else "several lines" if len(own) > 1 else "a line that is not of the program"
            faults.append((f"an error has {kind}", outcome.err[-300:]))
        elif elsewhere and elsewhere in own[0] and "temporary" not in own[0]:
            faults.append(("a message names a temporary file", own[0]))
        elif names and not any(name in own[0] for name in (*names, elsewhere)):
            faults.append(("an error names no file that the user knows", own[0]))
    elif len(lines) > 2 and not python:
        faults.append(("a success has several lines", outcome.err[-300:]))
    text = "\n".join(own) if prefixed else outcome.err  # mpirun also tells
    if any(word in text for word in BAD_WORDS):
        faults.append(("a message is of the C++ library or the system", outcome.err[-300:]))
    if not python and (TEMPORARY.search(outcome.err) or any(name in outcome.err for name in temporary)):
        faults.append(("a message names a temporary file", outcome.err[-300:]))
    return faults


@dataclasses.dataclass
class Messages:
    status: int
    err: str
    seconds: float


def same_run(first, second):
    """Returns whether two reports are of the same run. Their times differ."""
    try:
        first, second = json.loads(first), json.loads(second)
        return first["parameters"] == second["parameters"] and len(first["steps"]) == len(second["steps"])
    except ValueError:
        return False
