"""Lets a program open only what it is told it may: by Landlock, with which a Linux process gives up rights (landlock(7)).

    python -I -S confinement.py COMMAND...

Its standard input is a connection (multiprocessing.connection), on which one message is read: what may be opened, and
variables of the environment. Then it becomes COMMAND, with the same standard input. It runs before any code of COMMAND and in
one thread, because a thread that is there already keeps its rights. What is given up nothing gives back, and children have no
more. Another process that has not given up the same cannot be looked into (/proc/PID, ptrace), nor be sent signals.
"""

from __future__ import annotations

import ctypes
import json
import multiprocessing.connection
import os
import struct
import sys
from typing import NamedTuple

# linux/landlock.h and unistd.h; the numbers of these calls are the same on all machines.
CREATE_RULESET, ADD_RULE, RESTRICT_SELF = 444, 445, 446
VERSION_FLAG, PATH_BENEATH = 1, 1
EXECUTE, WRITE_FILE, READ_FILE, READ_DIR = 1 << 0, 1 << 1, 1 << 2, 1 << 3
MAKE_CHAR, MAKE_BLOCK = 1 << 6, 1 << 11
REFER, TRUNCATE, IOCTL_DEV = 1 << 13, 1 << 14, 1 << 15
OF_FILES = EXECUTE | WRITE_FILE | READ_FILE | TRUNCATE | IOCTL_DEV
# How many rights on files there are since a version.
RIGHTS_SINCE = {1: 13, 2: 14, 3: 15, 5: 16}
ABSTRACT_SOCKETS, SIGNALS = 1 << 0, 1 << 1
NETWORK_SINCE, SCOPES_SINCE = 4, 6

# linux/prctl.h, linux/capability.h. Of root's powers that to pass over permissions of files is kept: Landlock bounds it.
SET_NO_NEW_PRIVS, CAPABILITY_VERSION, DAC_OVERRIDE = 38, 0x20080522, 1 << 1

RIGHTS = {
    "list": READ_DIR,
    "read": EXECUTE | READ_FILE | READ_DIR,
    "write": ((1 << 16) - 1) & ~(MAKE_CHAR | MAKE_BLOCK),
}

_libc = ctypes.CDLL(None, use_errno=True)


class Rule(NamedTuple):
    path: str  # a file, or a folder with all in it
    right: str  # one of RIGHTS


def _called(what: str, result: int) -> int:
    if result < 0:
        raise OSError(ctypes.get_errno(), f"{what}: {os.strerror(ctypes.get_errno())}")
    return result


def version() -> int:
    """Of the kernel's Landlock; 0: it has none, or it is switched off."""
    return max(0, _libc.syscall(CREATE_RULESET, None, ctypes.c_size_t(0), VERSION_FLAG))


def _handled(abi: int) -> int:
    return (1 << max(count for since, count in RIGHTS_SINCE.items() if since <= abi)) - 1


def _ruleset(abi: int) -> int:
    attributes = struct.pack("Q", _handled(abi))
    if abi >= NETWORK_SINCE:
        attributes += struct.pack("Q", 0)
    if abi >= SCOPES_SINCE:
        attributes += struct.pack("Q", ABSTRACT_SOCKETS | SIGNALS)
    made = _libc.syscall(CREATE_RULESET, attributes, ctypes.c_size_t(len(attributes)), 0)
    return _called("landlock_create_ruleset", made)


def _allow(ruleset: int, rule: Rule, handled: int) -> None:
    try:
        place = os.open(rule.path, os.O_PATH | os.O_CLOEXEC)
    except OSError:
        return  # gone since it was named: nothing is allowed
    allowed = RIGHTS[rule.right] & handled
    if not os.path.isdir(rule.path):
        allowed &= OF_FILES
    given = struct.pack("=Qi", allowed, place)
    _called(f"landlock_add_rule {rule.path}", _libc.syscall(ADD_RULE, ruleset, PATH_BENEATH, given, 0))
    os.close(place)


def _give_up_powers() -> None:
    header = struct.pack("Ii", CAPABILITY_VERSION, 0)
    has = ctypes.create_string_buffer(24)
    _called("capget", _libc.capget(header, has))
    effective, permitted, *_ = struct.unpack("6I", has.raw)
    kept = struct.pack("6I", effective & DAC_OVERRIDE, permitted & DAC_OVERRIDE, 0, 0, 0, 0)
    _called("capset", _libc.capset(header, kept))
    _called("prctl", _libc.prctl(SET_NO_NEW_PRIVS, 1, 0, 0, 0))


def confine(rules: list[Rule]) -> None:
    """From now on this thread, and what it starts, opens nothing else. Raises OSError."""
    abi = version()
    if abi < 1:
        raise OSError("this kernel has no Landlock")
    ruleset = _ruleset(abi)
    for rule in rules:
        _allow(ruleset, rule, _handled(abi))
    _give_up_powers()
    _called("landlock_restrict_self", _libc.syscall(RESTRICT_SELF, ruleset, 0))
    os.close(ruleset)


def confined_command(command: list[str]) -> list[str]:
    """Of a process that is confined before it becomes `command`; its first message is `told`."""
    return [command[0], "-I", "-S", os.path.abspath(__file__), *command]


def told(rules: list[Rule], environment: dict[str, str]) -> bytes:
    return json.dumps({"rules": rules, "environment": environment}).encode()


def _main() -> None:
    os.closerange(3, os.sysconf("SC_OPEN_MAX"))  # what our parent had open without knowing
    connection = multiprocessing.connection.Connection(0)
    message = json.loads(connection.recv_bytes())
    try:
        confine([Rule(*rule) for rule in message["rules"]])
    except OSError as fault:  # as answers.py writes it
        connection.send_bytes(json.dumps(["error", f"it cannot be isolated: {fault.strerror or fault}"]).encode())
        return
    os.environ.update(message["environment"])
    os.execv(sys.argv[1], sys.argv[1:])


if __name__ == "__main__":
    _main()
