"""Policies from outside: models in servers of others and in checkpoints, behind rows of adapters (docs/remote.md).

    addresses.py          who is named by a text        adapters.py    rows: what a model sees and says
    openpi.py, groot.py   protocols of servers          adaptation.py  a row at work
    lerobot.py            checkpoints                   acting.py      asked for some steps at a time
"""

from __future__ import annotations

from typing import Any

from ..arguments import a_text
from ..errors import Error
from ..policy_process import policy_of_text
from .adapters import adapter_named
from .addresses import OWN, is_address, server_policy
from .lerobot import LerobotPolicy


def policy_named(text: str, adapter: str | None) -> Any:
    """What evaluate() runs, of a text: one of the program's own as it is, else an object.

    Raises Error usage.bad_flag, input.not_found, and those of rows of adapters.
    """
    if is_address(text):
        return server_policy(text, adapter_named, None if adapter is None else a_text("adapter", adapter))
    if text.startswith(LerobotPolicy.PREFIX):
        return LerobotPolicy.of_text(text, None if adapter is None else adapter_named(adapter))
    if adapter is not None:
        raise Error("usage.bad_flag", "adapter", f"{text!r} sees and acts as environments do: rows of adapters are for openpi://HOST:PORT, lerobot:FOLDER and the like")
    if ":" in text and not text.startswith(OWN):
        return policy_of_text(text)
    return text
