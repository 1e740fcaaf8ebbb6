"""What every call raises that cannot do what was asked."""

import re


class Error(RuntimeError):
    """A stable code, the place, and a sentence for a person.

    code     "camera.outside_store"
    where    the argument, the file and line
    message  what was wrong and what mends it
    """

    def __init__(self, code, where, message):
        super().__init__(f"{code} {where}: {message}" if where else f"{code}: {message}")
        self.code, self.where, self.message = code, where, message

    def __reduce__(self):
        return type(self), (self.code, self.where, self.message)


class StoreWarning(UserWarning):
    """A store was made, but it is not what was asked for."""


class IsolationWarning(UserWarning):
    """A policy runs where it could read the episodes' truth."""


# The library says what mends an error in the words of the command line. Flags that are switches here, and those whose value is
# said with them; every other flag is an argument of the same name.
_SWITCHES = ("resume", "strict", "previews")
_WITH_VALUE = ("camera", "control-mode", "country", "denoise", "mode", "planner", "profile", "quality", "style")
_OTHER_NAMES = {"act-limit-s": "act_limit_s", "truth": "policy"}
_FLAG = re.compile(r"(?<![\w-])--([a-z][a-z0-9-]*)(?: ([a-z][a-z0-9.]*(?::[a-z0-9.-]*[a-z0-9])?))?")
_QUOTED = re.compile(r'("[^"]*")')  # commands for the shell, and what somebody wrote: as they are


def _argument(found: re.Match) -> str:
    flag, word = found.groups()
    name = _OTHER_NAMES.get(flag, flag.replace("-", "_"))
    if flag in _SWITCHES:
        return f"{name}=True" + (f" {word}" if word else "")
    if word and flag in _WITH_VALUE:
        return f'{name}="{word}"'
    return name + (f" {word}" if word else "")


def in_python(text: str) -> str:
    """`text` of the library with Python's arguments for flags: 'take --denoise own' is 'take denoise="own"'."""
    pieces = _QUOTED.split(text)
    return "".join(piece if i % 2 else _FLAG.sub(_argument, piece) for i, piece in enumerate(pieces))


def of_library(code, where, message):
    """The error that the library gave; `where` may be a flag with its value."""
    return Error(code, in_python(where), in_python(message))
