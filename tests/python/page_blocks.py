"""The fenced blocks of a page, and what stands before them in comments that readers do not see.

    <!-- not run: REASON -->        the block is shown and not run
    <!-- needs: MODULE -->          it is run where Python has the module
    <!-- quick: NAME=VALUE ... -->  tests set these variables, which the block itself names as ${NAME:-DEFAULT}
"""

import dataclasses
import pathlib
import re

FENCE = re.compile(r"^```(?P<language>\w*)(?: title=\"(?P<title>[^\"\n]+)\")?\n(?P<body>.*?)^```", re.S | re.M)
MARKS = re.compile(r"((?:<!-- [^>]+? -->\s*)*)\Z")
MARK = re.compile(r"<!-- (not run|needs|quick): (.+?) -->")


@dataclasses.dataclass(frozen=True)
class Block:
    language: str
    title: str | None  # the file that it is
    body: str
    line: int  # of its first line in the page
    place: tuple[int, int]  # of its body in the page's text
    marks: dict[str, str]


def blocks_of(page: pathlib.Path) -> list[Block]:
    text = page.read_text(encoding="utf-8")
    return [
        Block(
            language=found["language"],
            title=found["title"],
            body=found["body"],
            line=text[: found.start("body")].count("\n") + 1,
            place=found.span("body"),
            marks=dict(MARK.findall(MARKS.search(text[: found.start()])[1])),
        )
        for found in FENCE.finditer(text)
    ]


def prose_of(page: pathlib.Path) -> str:
    """The page without its blocks."""
    return FENCE.sub("", page.read_text(encoding="utf-8", errors="replace"))
