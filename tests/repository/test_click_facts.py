"""Citations of facts about CLICK, and the page that they lead to: docs/click-facts.md.

This file has examples of citations and of texts that must not be one; it is left out of the search.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path
from typing import NamedTuple

import pytest

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs" / "click-facts.md"
SEARCHED = ("clickgen", "docs", "findings", "fixtures", "grammar", "scripts", "tests")
ENDINGS = (".lark", ".md", ".py", ".pyi", ".sh", ".txt", ".toml")

SOURCES = {"assumption", "captures", "export", "help", "report", "standard", "tool"}
CERTAINTIES = {"assumed", "certain", "disputed", "likely"}

_HEADING = re.compile(r"^#{2,3} (.+)$")
_FACT = re.compile(r"^- \*\*\[([^\]]*)\]\*\* (.+)$", re.DOTALL)
_ID = re.compile(r"[a-z]+(-[a-z]+)*\.[a-z0-9]+(-[a-z0-9]+)*")
_TAIL = re.compile(
    r"^(?P<said>.+?) \*Source: (?P<sources>[^;*]+); (?P<certainty>\w+)(?P<background>; background)?\.\*$"
)
_DETAIL = re.compile(r" \([^()]*\)")

_MENTION = re.compile(r"click[- ]facts", re.IGNORECASE)
_NEXT = r"(?:\s+(?:#\s+)?)"
"""A citation may continue on the next line, also in a comment."""
_CITATION = re.compile(rf"click-facts{_NEXT}\[([^\]]*)\]")
_PAGE_NAME = re.compile(r"click[-_]facts\.(?:md|py)")
_FORMER = re.compile(r"\bE341\b|\bdecisions\.md|\btraps? \d|\((?:click-facts, )?sections? \d\)", re.IGNORECASE)


class Fact(NamedTuple):
    """One fact of the page. ``tail`` is None if it does not end with source and certainty."""

    group: str
    id: str
    tail: re.Match[str] | None


def facts_of(page: str) -> Iterator[Fact]:
    group, item = "", ""
    for line in [*page.split("\n"), ""]:
        if item and not line.startswith("  "):
            fact = _FACT.match(item)
            assert fact is not None, f"no fact: {item}"
            yield Fact(group, fact[1], _TAIL.match(fact[2]))
            item = ""
        heading = _HEADING.match(line)
        if heading:
            group = heading[1]
        elif line.startswith("- "):
            item = line
        elif item:
            item += f" {line.strip()}"


def cited_in(text: str) -> Iterator[str]:
    """The ids of every citation. Raises ValueError for a mention of the facts that is not a citation."""
    former = _FORMER.search(text)
    if former:
        raise ValueError(f"{former[0]!r} names no fact")
    for mention in _MENTION.finditer(text):
        if _PAGE_NAME.match(text, mention.start()):
            continue
        citation = _CITATION.match(text, mention.start())
        if citation is None:
            raise ValueError(f"{text[mention.start() : mention.end() + 20]!r} cites no fact")
        for id in re.split(rf",{_NEXT}", citation[1]):
            if not _ID.fullmatch(id):
                raise ValueError(f"{id!r} is no id of a fact")
            yield id


def _files() -> Iterator[Path]:
    yield ROOT / "README.md"
    yield ROOT / "CHANGELOG.md"
    yield ROOT / "pyproject.toml"
    for folder in SEARCHED:
        for path in sorted((ROOT / folder).rglob("*")):
            if path.suffix in ENDINGS and path not in (PAGE, Path(__file__).resolve()) and path.is_file():
                yield path


@cache
def _citations() -> Mapping[str, list[str]]:
    """Every id that is cited, with the files that cite it."""
    found: dict[str, list[str]] = {}
    for path in _files():
        name = path.relative_to(ROOT).as_posix()
        try:
            for id in cited_in(path.read_text("utf-8", errors="replace")):
                found.setdefault(id, []).append(name)
        except ValueError as error:
            raise AssertionError(f"{name}: {error}") from error
    return found


FACTS = list(facts_of(PAGE.read_text("utf-8")))


def test_every_citation_leads_to_a_fact() -> None:
    known = {fact.id for fact in FACTS}
    assert {id: files for id, files in _citations().items() if id not in known} == {}


def test_every_fact_is_cited_or_background() -> None:
    cited = _citations()
    background = {fact.id for fact in FACTS if fact.tail and fact.tail["background"]}
    assert [fact.id for fact in FACTS if fact.id not in cited and fact.id not in background] == []
    assert sorted(background & set(cited)) == [], "what the code cites is no background"


def test_every_fact_has_source_and_certainty() -> None:
    for fact in FACTS:
        assert fact.tail is not None, f"{fact.id} does not end with: *Source: help, tool; certain.*"
        sources = _DETAIL.sub("", fact.tail["sources"]).split(", ")
        assert set(sources) <= SOURCES, f"{fact.id}: {sources}"
        assert len(set(sources)) == len(sources), f"{fact.id}: {sources}"
        assert fact.tail["certainty"] in CERTAINTIES, f"{fact.id}: {fact.tail['certainty']}"


def test_what_nobody_says_is_assumed() -> None:
    """An assumed fact ends in an assumption, and a fact without another source is assumed."""
    for fact in FACTS:
        assert fact.tail is not None
        sources = _DETAIL.sub("", fact.tail["sources"]).split(", ")
        if fact.tail["certainty"] == "assumed":
            assert sources[-1] == "assumption", fact.id
        assert sources != ["assumption"] or fact.tail["certainty"] == "assumed", fact.id
        assert "assumption" not in sources or fact.tail["certainty"] != "certain", fact.id
        assert fact.tail["certainty"] != "disputed" or len(sources) > 1, f"{fact.id}: who contradicts?"


def test_ids_are_unique_and_in_order() -> None:
    ids = [fact.id for fact in FACTS]
    assert [id for id in ids if not _ID.fullmatch(id)] == []
    assert len(set(ids)) == len(ids)
    groups: dict[str, list[str]] = {}
    for fact in FACTS:
        groups.setdefault(fact.group, []).append(fact.id)
    assert {group: members for group, members in groups.items() if members != sorted(members)} == {}
    homes: dict[str, set[str]] = {}
    for fact in FACTS:
        homes.setdefault(fact.id.partition(".")[0], set()).add(fact.group)
    assert {word: titles for word, titles in homes.items() if len(titles) > 1} == {}


def test_the_page_explains_its_words() -> None:
    explained = set(re.findall(r"^\| (\w+) \|", PAGE.read_text("utf-8"), re.MULTILINE)) - {"Source", "Certainty"}
    assert explained == SOURCES | CERTAINTIES


@pytest.mark.parametrize(
    ("text", "ids"),
    [
        ("see click-facts [grid.rows].", ["grid.rows"]),
        ("(click-facts [bank.ranges, grid.rows])", ["bank.ranges", "grid.rows"]),
        ("# no source says (click-facts\n    # [bank.ranges,\n    # grid.rows])", ["bank.ranges", "grid.rows"]),
        ("written from docs/click-facts.md, and tested by tests/repository/test_click_facts.py", []),
    ],
)
def test_citations_are_found(text: str, ids: list[str]) -> None:
    assert list(cited_in(text)) == ids


@pytest.mark.parametrize(
    "text",
    [
        "(click-facts, section 5)",
        "by the rules of click-facts alone",
        "Click facts, 3",
        "click-facts []",
        "click-facts [grid]",
        "click-facts [Grid.Rows]",
        "click-facts [grid.rows, ]",
        "(section 4)",
        "trap 3",
        "E341",
        "decisions.md",
    ],
)
def test_what_cites_no_fact_is_refused(text: str) -> None:
    with pytest.raises(ValueError, match=r"no fact|no id of a fact"):
        list(cited_in(text))
