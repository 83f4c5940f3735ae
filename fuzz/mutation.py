"""Mutations of what is sound: of the values and the nesting of a document, and of plain bytes."""

from __future__ import annotations

import copy
import json
import math

from hypothesis import strategies as st

MOST_EDITS = 4
NUMBERS = (
    *(0, 1, -1, 2, 3, 21, 2**31, 2**63, 2**70, -(2**63)),
    *(0.0, -0.0, 0.25, 0.5, 1.0, -1.0, 0.999999, math.pi, 1e-9, 1e9, 1e16),
    *(5e-324, 1e-300, 1e-100, 1e99, 1e100, 1e101, 1e154, 1e200, 1.7e308),
    *(math.inf, -math.inf, math.nan),
)
TEXTS = (
    *("", " ", "x", "nan", "inf", "1e999", "pi", "-pi/0", "pi/1e-320", "1e308 pi", "90 deg"),
    *("1" * 70, "x" * 5000, "٣ deg", "\0", "a\nb", "é\u202e", "[red]", "{words}", "/", ".."),
)
TOKENS = (
    *(b"\0", b"\xff\xfe", b"\xef\xbb\xbf", b"\xc3", b"\r", b"\n", b"#", b"=", b".", b",", b"-"),
    *(b'"', b'"""', b"'''", b"\\u0000", b"[", b"]", b"[[", b"{", b"}", b"e400", b"inf", b"nan"),
    *(b"9" * 5000, b"[" * 400, b"{a=" * 30, b"a." * 400, b"_", b"0x", b"1979-05-27", b"true"),
)


def values(words=(), odd=()):
    """Draw a value that is seldom wanted; `words` and `odd` values are the subject's own."""
    scalars = st.sampled_from((*NUMBERS, *TEXTS, *words, *odd, True, False)) | st.floats()
    lists = st.lists(scalars, max_size=4)
    tables = st.dictionaries(st.sampled_from((*words, "", "x", "name")), scalars, max_size=3)
    return scalars | lists | tables | st.lists(lists, max_size=3)


@st.composite
def edited(draw, tree, words, odd=()):
    """Draw a document that differs from `tree` in a few places."""
    tree = {"document": copy.deepcopy(tree)}
    for _ in range(draw(st.integers(1, MOST_EDITS))):
        _edit(draw, tree, words, odd)
    return tree["document"]


def _edit(draw, tree, words, odd):
    # The document itself is the last place, so that search and shrinking begin inside of it.
    below = [*_places(tree["document"]), (tree, "document")]
    container, key = draw(st.sampled_from(below))
    match draw(st.sampled_from(("replace", "remove", "copy", "add", "wrap", "unwrap"))):
        case "replace":
            container[key] = draw(values(words, odd))
        case "remove" if container is not tree:
            del container[key]
        case "copy":
            other, where = draw(st.sampled_from(below))
            container[key] = copy.deepcopy(other[where])
        case "add" if isinstance(container[key], dict):
            container[key][draw(st.sampled_from(("x", *words)))] = draw(values(words, odd))
        case "add" if isinstance(container[key], list):
            container[key].append(copy.deepcopy(container[key][0]) if container[key] else 0)
        case "wrap":
            container[key] = [container[key]]
        case "unwrap" if isinstance(container[key], list) and container[key]:
            container[key] = container[key][0]


def _places(tree):
    """Return every (table or list, key or index) of a document."""
    if isinstance(tree, dict | list):
        for key in tree if isinstance(tree, dict) else range(len(tree)):
            yield tree, key
            yield from _places(tree[key])


@st.composite
def damaged(draw, content):
    """Draw bytes that differ from `content` in a few places."""
    for _ in range(draw(st.integers(1, MOST_EDITS))):
        first, last = sorted(draw(st.tuples(*2 * (st.integers(0, len(content)),))))
        new = draw(st.just(b"") | st.sampled_from(TOKENS) | st.binary(max_size=8))
        # Where the old content goes on: never, later, earlier, or where it was overwritten.
        rest = draw(st.sampled_from((len(content), last, first // 2, first + len(new))))
        content = content[:first] + new + content[rest:]
    return content


def toml(document):
    """Write a document as TOML, every table inline."""
    if not isinstance(document, dict):
        return toml_value(document).encode(errors="surrogatepass")
    lines = [f"{json.dumps(key)} = {toml_value(value)}\n" for key, value in document.items()]
    return "".join(lines).encode(errors="surrogatepass")


def toml_value(value):
    """Write a value as TOML."""
    match value:
        case dict():
            parts = (f"{json.dumps(key)} = {toml_value(part)}" for key, part in value.items())
            return "{" + ", ".join(parts) + "}"
        case list():
            return "[" + ", ".join(map(toml_value, value)) + "]"
        case str() | bool():
            return json.dumps(value)
    return repr(value)
