"""How a policy from outside is named: "openpi://localhost:8000", with or without "remote:" before it."""

from __future__ import annotations

import dataclasses
import importlib.util
import re
from collections.abc import Callable
from typing import Any

from ..errors import Error
from .acting import Model, ModelActs
from .adapters import Adapter
from .groot import Groot
from .openpi import OpenPi

PREFIX = "remote:"
ADDRESS = re.compile(r"(?P<host>\[[0-9a-fA-F:.]+\]|[A-Za-z0-9._-]+):(?P<port>[0-9]{1,5})/?")
MAX_PORT = 65535


@dataclasses.dataclass(frozen=True)
class Protocol:
    """What a scheme means.

    needs  modules, by what pip calls them
    model  of address, start_limit_s, hang_limit_s
    adapter  the row without another
    """

    needs: dict[str, str]
    model: Callable[[str, float, float], Model]
    adapter: str


PROTOCOLS = {
    "openpi": Protocol({"websockets": "websockets", "msgpack": "msgpack"}, OpenPi, "marketgen"),
    "groot": Protocol({"zmq": "pyzmq", "msgpack": "msgpack"}, Groot, "groot-panda"),
}


@dataclasses.dataclass(frozen=True)
class ServerPolicy:
    """A policy that acts in a server which somebody else has started."""

    scheme: str
    address: str
    adapter: Adapter

    @property
    def name(self) -> str:
        """In results."""
        return f"{self.scheme}({self.adapter.name})"

    def acting(self, start_limit_s: float, hang_limit_s: float) -> ModelActs:
        """With a connection of its own, made at the first episode."""
        return ModelActs(self.adapter, PROTOCOLS[self.scheme].model(self.address, start_limit_s, hang_limit_s))

    def check_there(self, start_limit_s: float, hang_limit_s: float) -> None:
        """Raises Error episode.no_policy before any episode is run, usage.unavailable."""
        missing = [package for module, package in PROTOCOLS[self.scheme].needs.items() if importlib.util.find_spec(module) is None]
        if missing:
            raise Error("usage.unavailable", ", ".join(missing), "policies of servers need it: pip install 'marketgen[remote]'")
        model = PROTOCOLS[self.scheme].model(self.address, start_limit_s, hang_limit_s)
        try:
            model.begin()
        finally:
            model.close()


# Policies of the program that name in brackets what they ask elsewhere (docs/vlm.md, docs/hybrid.md).
OWN = ("vlm(", "hybrid(")


def is_address(text: str) -> bool:
    return not text.startswith(OWN) and ("://" in text or text.startswith(PREFIX))


def parts_of(text: str) -> tuple[str, str]:
    """Scheme and host:port. Raises Error usage.bad_flag."""
    scheme, _, rest = text.removeprefix(PREFIX).partition("://")
    if scheme not in PROTOCOLS:
        raise Error("usage.bad_flag", "policy", f"{text!r}: expected one of {', '.join(f'{name}://HOST:PORT' for name in PROTOCOLS)}")
    found = ADDRESS.fullmatch(rest)
    if found is None or not 0 < int(found["port"]) <= MAX_PORT:
        raise Error("usage.bad_flag", "policy", f"{text!r}: expected {scheme}://HOST:PORT, as {scheme}://localhost:8000")
    return scheme, f"{found['host']}:{found['port']}"


def server_policy(text: str, adapter: Callable[[str], Adapter], row: str | None) -> Any:
    """`row`: of `adapter`; None: that of the protocol."""
    scheme, address = parts_of(text)
    return ServerPolicy(scheme, address, adapter(row or PROTOCOLS[scheme].adapter))
