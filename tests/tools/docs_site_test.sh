#!/usr/bin/env bash
# The documentation's site is built, leads nowhere that is not there, and loads nothing from elsewhere.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

fail() { printf 'docs_site_test: %s\n' "$1" >&2; exit 1; }

tools/docs > /dev/null
.venv/bin/python - <<'PYTHON' || fail 'see above'
import html.parser
import pathlib
import sys
import urllib.parse

site = pathlib.Path("build/site").resolve()
pages = sorted(site.rglob("*.html"))
faults = []


class Page(html.parser.HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.ids, self.links, self.loads = set(), [], []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        self.ids.update(name for name in (given.get("id"), given.get("name")) if name)
        if tag == "a" and given.get("href"):
            self.links.append(given["href"])
        if tag in ("script", "img", "source", "iframe") and given.get("src"):
            self.loads.append(given["src"])
        if tag == "link" and given.get("rel") in ("stylesheet", "icon", "preload") and given.get("href"):
            self.loads.append(given["href"])


read = {page: Page(page.read_text()) for page in pages}
for page, parsed in read.items():
    for address in parsed.loads:
        if urllib.parse.urlsplit(address).scheme in ("http", "https"):
            faults.append(f"{page.name} loads {address}")
    for link in parsed.links:
        parts = urllib.parse.urlsplit(link)
        if parts.scheme or parts.netloc or page.name == "404.html":
            continue
        target = (page.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else page
        if not target.exists():
            faults.append(f"{page.name} leads to {link}, which is not there")
        elif parts.fragment and target in read and urllib.parse.unquote(parts.fragment) not in read[target].ids:
            faults.append(f"{page.name} leads to {link}, which has no such place")
for source in pathlib.Path("docs").glob("*.md"):
    if not (site / "docs" / source.with_suffix(".html").name).exists():
        faults.append(f"{source} is no page of the site")
reference = (site / "docs/reference.html").read_text()
for name in ("generate", "evaluate", "Store.show", "Frame.save"):
    if f">{name}<" not in reference:
        faults.append(f"the reference has no {name}")
print(len(pages), "pages")
sys.exit("\n".join(faults) if faults else 0)
PYTHON

status=0
tools/docs --weave > /dev/null 2>&1 || status=$?
[ "$status" = 2 ] || fail "--weave ends with $status, not 2"
