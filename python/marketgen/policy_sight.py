"""What of the file system a policy's process may open: what Python code needs, and nothing of the episodes' truth.

    the system       programs, libraries, settings, /proc, /sys, graphics processors
    Python           the interpreter's folders and all packages
    its code         the folders of sys.path, where modules lie beside their weights
    what is named    files and folders that the caller gives it, to read and write

Folders of code often hold stores and episodes as well. So those outside Python's own are searched, and of a folder in which
something is hidden all else is given piece by piece. Hidden are, wherever they lie: what the caller names, folders of stores,
files of episodes. Copies in other forms (archives, exported scenes) are not known.
"""

from __future__ import annotations

import glob
import os
import site
import sys
import sysconfig
from collections.abc import Iterable, Iterator

from .confinement import Rule
from .errors import Error

SYSTEM = (
    *("/bin", "/sbin", "/lib", "/lib32", "/lib64", "/libx32", "/etc", "/nix/store", "/gnu/store", "/proc", "/sys"),
    *("/usr/bin", "/usr/sbin", "/usr/lib*", "/usr/share", "/usr/include"),
    *("/usr/local/bin", "/usr/local/sbin", "/usr/local/lib*", "/usr/local/share", "/usr/local/include", "/usr/local/etc"),
    *("/usr/local/cuda*", "/opt/rocm*", "/opt/cuda*", "/opt/nvidia*", "/run/systemd/resolve", "/run/resolvconf"),
)
DEVICES = (
    *("/dev/null", "/dev/zero", "/dev/full", "/dev/random", "/dev/urandom", "/dev/tty", "/dev/ptmx", "/dev/pts"),
    *("/dev/nvidia*", "/dev/dri", "/dev/kfd"),
)
# Of an interpreter's own prefix, and of conda's; a project may lie beside them.
OF_PREFIX = ("bin", "lib", "lib32", "lib64", "libexec", "include", "share", "etc", "ssl", "pkgs", "envs", "conda-meta")
SYSTEM_PREFIXES = ("/", "/usr", "/usr/local")
SHARED_MEMORY = "/dev/shm"
SCENE = "scene.bin"  # a folder that has it is a store
EPISODES = b'"market-episode'  # how a file of episodes, or an episode, begins
EPISODES_NAMES = (".json", ".jsonl", ".ndjson")
HEAD_BYTES = 256
MAX_SEARCHED = 500_000  # files and folders of one place: two seconds


def sight(hidden: Iterable[str], *, code: Iterable[str] = (), files: Iterable[str] = ()) -> list[Rule]:
    """`code`: to read, beside what this process has loaded. `files`: to read and write.

    Raises Error usage.bad_flag when a folder is too large to be searched.
    """
    places = _Places([os.path.realpath(path) for path in hidden], _trusted())
    rules = [Rule(path, "write") for pattern in DEVICES for path in glob.glob(pattern)]
    for folder in (*_system(), *places.trusted):
        rules += places.along(Rule(folder, "read"))
    for place in _outermost((*_code(), *code)):
        rules += places.searched(Rule(place, "read"))
    for place in (SHARED_MEMORY, *files):
        rules += places.searched(Rule(os.path.realpath(place), "write"))
    return list(dict.fromkeys(rules))


def _system() -> list[str]:
    return sorted({os.path.realpath(path) for pattern in SYSTEM for path in glob.glob(pattern)})


def _prefixes() -> list[str]:
    return [prefix for prefix in (sys.prefix, sys.base_prefix, sys.exec_prefix) if prefix not in SYSTEM_PREFIXES]


def _trusted() -> tuple[str, ...]:
    """Python's own folders, and those of packages that were installed."""
    names = ("stdlib", "platstdlib", "purelib", "platlib")
    folders = {sysconfig.get_paths()[name] for name in names} | {*site.getsitepackages(), site.getusersitepackages()}
    folders |= {os.path.join(prefix, name) for prefix in _prefixes() for name in OF_PREFIX}
    return tuple(sorted({os.path.realpath(folder) for folder in folders if os.path.isdir(folder)}))


def _code() -> Iterator[str]:
    yield from (entry or os.getcwd() for entry in sys.path)
    yield from _prefixes()
    yield os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    for name, module in list(sys.modules.items()):  # packages installed where they are written: no folder of sys.path has them
        if "." not in name and getattr(module, "__spec__", None) is not None:
            yield from module.__spec__.submodule_search_locations or [module.__spec__.origin or ""]
    with open("/proc/self/maps", encoding="utf-8", errors="surrogateescape") as maps:  # libraries
        for words in map(str.split, maps):
            if len(words) == 6 and "x" in words[1]:
                yield words[5]


def _outermost(places: Iterable[str]) -> list[str]:
    """Those that are there, without those within another of them or in the system's folders."""
    kept, system = [], _system()
    for place in sorted({os.path.realpath(place) for place in places if os.path.exists(place)}):
        if not any(_within(place, outer) for outer in (*kept, *system)):
            kept.append(place)
    return kept


def _within(path: str, folder: str) -> bool:
    return path == folder or path.startswith(folder.rstrip("/") + "/")


class _Places:
    """hidden: real paths. trusted: real paths of folders that are not searched."""

    def __init__(self, hidden: list[str], trusted: tuple[str, ...]):
        self.hidden, self.trusted = frozenset(hidden), trusted
        self._twins = {_identity(os.stat(path)) for path in hidden if os.path.isfile(path)}
        self._left = 0

    def along(self, rule: Rule) -> list[Rule]:
        """The rule, in pieces where something that is named as hidden lies within."""
        return self._pieces(rule, self.along) if self._hides(rule.path) else [rule]

    def searched(self, rule: Rule) -> list[Rule]:
        """The rule, in pieces where something hidden is found within."""
        self._left = MAX_SEARCHED
        try:
            return self._found(rule)
        except _TooMany:
            raise Error(
                "usage.bad_flag",
                "policy",
                f"a policy's process may open {rule.path}, which has more than {MAX_SEARCHED:,} files: too many to look for "
                "stores and episodes among them. Put the policy's code into a folder of its own, and run from there",
            ) from None

    def _found(self, rule: Rule) -> list[Rule]:
        if rule.path in self.trusted:
            return self.along(rule)
        return self._pieces(rule, self._found)

    def _pieces(self, rule: Rule, within) -> list[Rule]:
        """The rule where `within` leaves all that lies in it whole; else its pieces, and names may be listed."""
        if rule.path in self.hidden:
            return []
        if not os.path.isdir(rule.path):
            return [] if self._is_truth(rule.path) else [rule]
        try:
            with os.scandir(rule.path) as listed:
                entries = list(listed)
        except OSError:
            return [rule]  # we cannot list it, so the policy cannot
        self._left -= len(entries)
        if self._left < 0 and within == self._found:
            raise _TooMany
        if any(entry.name == SCENE for entry in entries):
            return []
        pieces, whole = [], not self._hides(rule.path)
        for entry in entries:
            if entry.is_symlink():
                continue  # what it points to is given, or not, where it lies
            given = within(Rule(entry.path, rule.right))
            whole = whole and given == [Rule(entry.path, rule.right)]
            pieces += given
        return [rule] if whole else [Rule(rule.path, "list"), *pieces]

    def _hides(self, folder: str) -> bool:
        """It may be that what is named is not there yet."""
        return any(_within(path, folder) for path in self.hidden)

    def _is_truth(self, path: str) -> bool:
        try:
            if _identity(os.stat(path)) in self._twins:
                return True
            if not path.endswith(EPISODES_NAMES) or not os.path.isfile(path):
                return False
            with open(path, "rb") as file:
                return EPISODES in file.read(HEAD_BYTES)
        except OSError:
            return False  # it is gone, or not ours to read


class _TooMany(Exception):
    pass


def _identity(about: os.stat_result) -> tuple[int, int]:
    return about.st_dev, about.st_ino
