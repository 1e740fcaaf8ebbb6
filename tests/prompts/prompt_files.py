"""Files of prompts, one JSON record a line. The sealed one is compressed, so that no search and no diff shows it by chance."""
import gzip
import json
import pathlib

SEALED = "unread.jsonl.gz"


def is_sealed(path):
    path = pathlib.Path(path)
    return SEALED in (path.name, path.resolve().name)


def read_prompts(path):
    path = pathlib.Path(path)
    content = path.read_bytes()
    text = (gzip.decompress(content) if path.suffix == ".gz" else content).decode("utf-8")
    return [json.loads(line) for line in text.splitlines() if line.strip()]
