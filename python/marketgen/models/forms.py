"""Bodies of multipart/form-data (RFC 7578), as `requests.post(url, files={"image": ...})` and curl's -F send them."""

from __future__ import annotations

import dataclasses
from email.message import Message

MAX_PARTS, MAX_HEAD = 256, 8192


class BadForm(Exception):
    """The body is no such form; the text says why."""


@dataclasses.dataclass(frozen=True)
class Part:
    name: str
    content: bytes


def parts_of(content_type: str, body: bytes) -> list[Part]:
    """The fields in the order in which they were sent. Raises BadForm."""
    boundary = _boundary(content_type)
    mark = b"--" + boundary
    pieces = (b"\r\n" + body).split(b"\r\n" + mark)
    if len(pieces) < 2:
        raise BadForm("the body does not have the boundary that its Content-Type names")
    if len(pieces) - 2 > MAX_PARTS:
        raise BadForm(f"the form has more than {MAX_PARTS} fields")
    if not pieces[-1].startswith(b"--"):
        raise BadForm("the form has no end: it was cut off")
    return [_part(piece) for piece in pieces[1:-1]]


def _boundary(content_type: str) -> bytes:
    header = Message()
    header["Content-Type"] = content_type
    if header.get_content_type() != "multipart/form-data":
        told = content_type.split(";")[0][:80] or "none"
        raise BadForm(f"send multipart/form-data with the picture in the field `image`; the Content-Type is {told}")
    boundary = header.get_param("boundary")
    if not isinstance(boundary, str) or not 0 < len(boundary) <= 200 or not boundary.isascii():
        raise BadForm("the Content-Type has no boundary")
    return boundary.encode("ascii")


def _part(piece: bytes) -> Part:
    """Of what stands between two boundaries: white space, lines of a head, an empty line, the content."""
    head, found, content = piece.lstrip(b" \t").partition(b"\r\n\r\n")
    if not found or not head.startswith(b"\r\n") or len(head) > MAX_HEAD:
        raise BadForm("a field of the form has no head")
    for line in head.decode("utf-8", "replace").split("\r\n"):
        key, _, value = line.partition(":")
        if key.strip().lower() == "content-disposition":
            return Part(_name(value), content)
    raise BadForm("a field of the form has no Content-Disposition")


def _name(disposition: str) -> str:
    header = Message()
    header["Content-Disposition"] = " ".join(disposition.split())
    name = header.get_param("name", header="Content-Disposition")
    if header.get_content_disposition() != "form-data" or not isinstance(name, str):
        raise BadForm("a field of the form has no name")
    return name
