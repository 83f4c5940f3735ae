"""Cases of TOML files: edited examples, damaged text, any bytes."""

from __future__ import annotations

import tomllib
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

from hypothesis import strategies as st

from fuzz.mutation import damaged, edited, toml


def toml_cases(files, model):
    """Draw files like `files`; `model` is what pydantic knows of them."""
    texts = [file.read_bytes() for file in files]
    documents = [document for text in texts if (document := _read(text))]
    words = sorted(_words(model.model_json_schema()))
    edits = st.sampled_from(documents).flatmap(lambda document: edited(document, words)).map(toml)
    damage = st.sampled_from(texts).flatmap(damaged)
    return st.one_of(edits, edits, damage, st.binary(max_size=200))


def _read(text):
    """Return the document, or None: the corpus has files that aren't TOML."""
    try:
        return tomllib.loads(text.decode())
    except (ValueError, RecursionError):
        return None


def _words(schema):
    """Return every key and every word that a JSON schema knows."""
    found = set()
    if isinstance(schema, dict):
        found |= schema.get("properties", {}).keys()
        found |= {word for word in schema.get("enum", ()) if isinstance(word, str)}
        found |= {schema["const"]} if isinstance(schema.get("const"), str) else set()
    for part in schema.values() if isinstance(schema, dict) else schema:
        if isinstance(part, dict | list):
            found |= _words(part)
    return found


@contextmanager
def file_with(content, suffix):
    """Lend a file with this content."""
    with TemporaryDirectory() as folder:
        file = Path(folder) / f"case{suffix}"
        file.write_bytes(content)
        yield file
