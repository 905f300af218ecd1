"""Power loss: replays a log of system calls on a model of a file system, and cuts it after each call.

Data reach the disk with fsync() of the file, and names with fsync() of the folder. Without it, either the change or
the state before may be found after the cut."""
import os

from . import validate
from .system_calls import WRITES


class Inode:
    def __init__(self, data=b""):
        self.data = data
        self.safe = data  # what fsync() has written


class Disk:
    """Names and contents below a folder. `names` are those that the processes see, `safe` those on the disk."""

    def __init__(self, state, folder):
        self.folder = folder
        self.names = {place: None if content is None else Inode(content) for place, content in state.items()}
        self.safe = dict(self.names)
        self.positions = {}  # of descriptors

    def place(self, path):
        path = os.path.relpath(path, self.folder)
        return None if path.startswith("..") else path

    def apply(self, call):
        """Applies a call, and returns whether it changed anything."""
        if call.failed:
            return False
        name, place = call.name, self.place(call.path)
        if place is None:
            return False
        if call.creates:
            self._create(call, place)
        elif name in WRITES:
            return self._write(call, place)
        elif name == "lseek":
            self.positions[self._descriptor(call)] = call.result
        elif name == "ftruncate":
            size, inode = int(call.arguments.rsplit(", ", 1)[1]), self.names[place]
            inode.data = inode.data[:size].ljust(size, b"\0")
        elif name in ("sendfile", "copy_file_range", "fallocate"):
            raise NotImplementedError(f"{name} of {place}")
        elif name in ("rename", "renameat", "renameat2"):
            target = self.place(call.target)
            for moved in [n for n in self.names if n == place or n.startswith(place + "/")]:
                self.names[target + moved[len(place) :]] = self.names.pop(moved)
        elif name in ("unlink", "unlinkat", "rmdir"):
            self.names.pop(place, None)
        elif name in ("mkdir", "mkdirat"):
            self.names[place] = None
        elif name in ("fsync", "fdatasync"):
            self._synchronize(place)
        else:
            return False
        return True

    @staticmethod
    def _descriptor(call):
        return call.process, int(call.arguments.split("<")[0])

    def _create(self, call, place):
        self.positions[call.process, call.result] = 0
        if place not in self.names:
            self.names[place] = Inode()
        elif "O_TRUNC" in call.arguments:
            self.names[place].data = b""

    def _write(self, call, place):
        inode = self.names.get(place)
        if inode is None:
            return False  # the file has no name any more
        data = b"".join(call.texts)[: call.result]
        assert len(data) == call.result, "the log has not all data"
        descriptor = self._descriptor(call)
        at = self.positions.setdefault(descriptor, len(inode.data))
        if call.name == "pwrite64":
            at = int(call.arguments.rsplit(", ", 1)[1])
        else:
            self.positions[descriptor] = at + len(data)
        inode.data = inode.data[:at].ljust(at, b"\0") + data + inode.data[at + len(data) :]
        return True

    def _synchronize(self, place):
        inode = self.names.get(place)
        if isinstance(inode, Inode):
            inode.safe = inode.data
            return
        for names, other in (self.names, self.safe), (self.safe, self.names):
            for child in [n for n in names if (os.path.dirname(n) or ".") == place]:
                if child in self.names:
                    self.safe[child] = self.names[child]
                else:
                    del self.safe[child]

    def states(self):
        """Returns the states that may be found, with their names."""
        def contents(names, attribute):
            found = {}
            for name in sorted(names):
                parent = os.path.dirname(name)
                if not parent or parent in found:
                    found[name] = names[name] and getattr(names[name], attribute)
            return found

        yield "all calls are on the disk", contents(self.names, "data")
        yield "names are on the disk, data only after fsync", contents(self.names, "safe")
        yield "names and data are on the disk only after fsync", contents(self.safe, "safe")


def replay(calls, old, new, folder, judge):
    """Yields for each possible state after each call: the number of the call, the state, and its faults. The last
    item is the end of the run, when everything must be on the disk."""
    disk, seen = Disk(old, folder), {}
    for number, call in enumerate(calls):
        if not disk.apply(call):
            continue
        for kind, state in disk.states():
            known = {n: c for n, c in state.items() if n in old or n in new}
            key = hash(frozenset((n, c) for n, c in known.items()))
            if key not in seen:
                seen[key] = judge(known)
            yield number, kind, seen[key]
    volatile, _, durable = (state for _, state in disk.states())
    lost = [n for n in new if volatile.get(n) != durable.get(n)]
    yield len(calls), "the run has ended", [("a result of a complete run is not on the disk", n) for n in lost]
