"""Formulas by example: both modes, every construct, and mistakes at their place inside the string."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import clickgen
from clickgen.device.banks import Address
from clickgen.dialects.if_rungs.trade.formulas import formula_advice
from clickgen.formula import Formula, Mode, Operand, Sum, parse_formula, print_formula, print_source, references
from clickgen.formula import explain as explaining
from clickgen.formula.build import Builder
from clickgen.formula.mistakes import MISTAKES, SPELLINGS
from clickgen.formula.parse import grammar_text, reader
from clickgen.formula.words import TERMINAL
from clickgen.ir.operands import Cell, Named, Pointer, Range
from clickgen.problems.diagnostics import Diagnostic, Diagnostics
from clickgen.text.source import EmbeddedText, SourceFile, embedded_text

MODES: tuple[Mode, Mode] = ("decimal", "hex")


def embed(formula: str) -> EmbeddedText:
    """The formula as a literal that starts in column 5 of line 1: column = offset + 6, without escapes."""
    raw = "'" + formula.replace("\\", "\\\\").replace("'", "\\'").replace("\n", "\\n") + "'"
    return embedded_text(SourceFile("prog.py", f"    {raw}"), [(raw, 1, 5)], formula)


def read(formula: str, mode: Mode) -> tuple[Formula | None, list[Diagnostic]]:
    problems = Diagnostics()
    return parse_formula(embed(formula), mode, problems, "", formula_advice), problems.found


def native(ref: Named | Cell | Pointer | Range) -> str:
    """CLICK's text of an operand; names are unchanged."""
    if isinstance(ref, Range):
        return f"{ref.bank}{ref.first} : {ref.bank}{ref.last}"
    if isinstance(ref, Cell):
        return str(ref.address)
    return ref.name if isinstance(ref, Named) else f"{ref.bank}[{native(ref.register)}]"


def click(formula: str, mode: Mode = "decimal") -> str:
    read_formula, found = read(formula, mode)
    assert not [problem for problem in found if problem.is_error], found
    assert read_formula is not None
    return print_formula(read_formula, native)


def mistakes(formula: str, mode: Mode = "decimal") -> list[tuple[str, str]]:
    """Each problem's code and the text that it marks."""
    result, found = read(formula, mode)
    assert result is None
    assert all(problem.message and problem.span is not None for problem in found)
    return [(problem.code, shown(formula, problem)) for problem in found]


def shown(formula: str, problem: Diagnostic) -> str:
    assert problem.span is not None
    return formula[problem.span.col - 6 : problem.span.end_col - 6]


@pytest.mark.parametrize(
    ("source", "printed"),
    [
        ("( ds[181]*10 )+2991", "( DS181 * 10 ) + 2991"),
        ("SUM(ds[301:351])", "SUM ( DS301 : DS350 )"),
        ("sum ( ds[301 : 351] )", "SUM ( DS301 : DS350 )"),
        ("SUM(x[1:17])", "SUM ( X1 : X16 )"),
        ("ds[601] mod 2", "DS601 MOD 2"),
        ("sqrt(df[1])", "SQRT ( DF1 )"),
        ("ds.RawValue * 100 / 4095", "RawValue * 100 / 4095"),
        ('ds["My Value"] + 1', "My Value + 1"),
        ('xd["0u"] + xd[0]', "XD0u + XD0"),
        ("ds[0x10]", "DS16"),
        ("ds[ds.Index] + dd[ds[5]]", "DS[Index] + DD[DS5]"),
        ("x[1] + 0", "X001 + 0"),
        ("2 * pi * df.R ^ 2", "2 * PI * R ^ 2"),
        ("+ds.A - +5", "A - 5"),
        # numbers
        ("1.5 + .5 + 2. + 007", "1.5 + 0.5 + 2.0 + 007"),
        ("1e3 + 1.5E-3 + 2e+22", "1000.0 + 0.0015 + 20000000000000000000000.0"),
        ("0e999999999", "0.0"),
        # unary minus
        ("-ds.A", "0 - A"),
        ("-5", "0 - 5"),
        ("-ds.A + 5", "( 0 - A ) + 5"),
        ("ds.A * -ds.B", "A * ( 0 - B )"),
        ("--ds.A", "0 - ( 0 - A )"),
        ("(-ds.A)", "( 0 - A )"),
        ("SIN(-ds.A)", "SIN ( 0 - A )"),
        ("-df.A ^ 2", "0 - A ^ 2"),
        ("(-df.A) ^ 2", "( 0 - A ) ^ 2"),
        ("2 ^ -df.A", "2 ^ ( 0 - A )"),
        ("-(ds.A + ds.B)", "0 - ( A + B )"),
        # settled by usual maths: as written
        ("ds.A + ds.B * ds.C - ds.D / 2", "A + B * C - D / 2"),
        ("ds.A - ds.B - ds.C", "A - B - C"),
        ("ds.A / ds.B * ds.C", "A / B * C"),
        ("(((ds.A)))", "( ( ( A ) ) )"),
        # not settled: explicit
        ("2 ^ 3 ^ 2", "2 ^ ( 3 ^ 2 )"),
        ("(2 ^ 3) ^ 2", "( 2 ^ 3 ) ^ 2"),
        ("ds.A + ds.B MOD 3", "A + ( B MOD 3 )"),
        ("ds.A * ds.B MOD 3 MOD 2", "( ( A * B ) MOD 3 ) MOD 2"),
    ],
)
def test_decimal(source: str, printed: str) -> None:
    assert click(source) == printed


@pytest.mark.parametrize(
    ("source", "printed"),
    [
        ("dh.In AND 0x00FF", "In AND 00FFh"),
        ("dh.In and 00ffh", "In AND 00FFh"),
        ("dh.In OR FFh OR 0XfF", "In OR 00FFh OR 00FFh"),
        ("dh.FFh XOR dh.And", "FFh XOR And"),
        ("dh.A + 5", "A + 5h"),
        ("1E5h + 0x00000A", "1E5h + 000Ah"),
        ("Dh + 0Dh", "000Dh + 0Dh"),
        ("SHL(dh.A, 4)", "LSH ( A , 4h )"),
        ("dh.A shl 4", "LSH ( A , 4h )"),
        ("dh.A SHR 4 + 1", "RSH ( A , 4h ) + 1h"),
        ("lsh(dh.A, 1) + RSH(dh.A, 1)", "LSH ( A , 1h ) + RSH ( A , 1h )"),
        ("dh.A LRO 1 RRO 2", "RRO ( LRO ( A , 1h ) , 2h )"),
        ("dh.A + dh.B SHL 1", "A + LSH ( B , 1h )"),
        ("dh.A * dh.B SHL 1", "LSH ( A * B , 1h )"),
        ("(dh.A OR dh.B) SHL 1", "LSH ( ( A OR B ) , 1h )"),
        ("NOT dh.A", "A XOR FFFFh"),
        ("not(dh.A)", "( A ) XOR FFFFh"),
        ("NOT NOT dh.A", "( A XOR FFFFh ) XOR FFFFh"),
        ("NOT dh.A AND dh.B", "( A XOR FFFFh ) AND B"),
        ("dh.A AND NOT (dh.B OR dh.C)", "A AND ( ( B OR C ) XOR FFFFh )"),
        ("NOT dh.A SHL 1", "LSH ( A XOR FFFFh , 1h )"),
        ("-dh.A", "0h - A"),
        ("NOT -dh.A", "( 0h - A ) XOR FFFFh"),
        ("dh.A AND dh.B OR dh.C XOR dh.D", "( A AND B ) OR ( C XOR D )"),
        ("dh.A + dh.B AND dh.C", "( A + B ) AND C"),
        ("dh.A AND dh.B AND dh.C", "A AND B AND C"),
        ("SUM(dh[1:9]) MOD 0x10", "SUM ( DH1 : DH8 ) MOD 10h"),
        ("dh.A * dh.B - dh.C / 2", "A * B - C / 2h"),
    ],
)
def test_hex(source: str, printed: str) -> None:
    assert click(source, "hex") == printed


def test_decimal_number_in_hex_warns() -> None:
    formula, found = read("dh[10] + 10 + 9", "hex")
    assert formula is not None
    assert [(problem.code, shown("dh[10] + 10 + 9", problem)) for problem in found] == [("CG315", "10")]
    assert "000Ah" in found[0].message
    assert "0xA" in found[0].help
    assert print_formula(formula, native) == "DH10 + 000Ah + 9h"


@pytest.mark.parametrize(
    ("source", "mode", "expected"),
    [
        # what does not exist
        ("ds[5000] + ds[0]", "decimal", [("CG201", "ds[5000]"), ("CG201", "ds[0]")]),
        ("ds[-1] + ds[1.5]", "decimal", [("CG201", "ds[-1]"), ("CG113", "1.5")]),
        ("ds[10h] + SUM(ds[1h:5])", "decimal", [("CG113", "10h"), ("CG202", "ds[1h:5]")]),
        ("x[17] + xd[9]", "decimal", [("CG201", "x[17]"), ("CG201", "xd[9]")]),
        ("ds[-1.5]", "decimal", [("CG113", "1.5")]),
        ("di.A * 2", "decimal", [("CG113", "di")]),
        ("DS.A + DS[5]", "decimal", [("CG113", "DS"), ("CG113", "DS")]),
        ("DS5 + ds5 + XD0u", "decimal", [("CG113", "DS5"), ("CG113", "ds5"), ("CG113", "XD0u")]),
        ("Speed + ds + dh", "decimal", [("CG113", "Speed"), ("CG113", "ds"), ("CG113", "dh")]),
        ('ds[""]', "decimal", [("CG203", '""')]),
        # ranges
        ("SUM(ds[5:5])", "decimal", [("CG202", "ds[5:5]")]),
        ("SUM(ds[5:1]) + SUM(ds[5:1:-1])", "decimal", [("CG202", "ds[5:1]"), ("CG202", "ds[5:1:-1]")]),
        ("SUM(ds[1:9:2]) + SUM(ds[:9])", "decimal", [("CG202", "ds[1:9:2]"), ("CG202", "ds[:9]")]),
        ("SUM(x[10:30])", "decimal", [("CG202", "x[10:30]")]),
        ("SUM(ds[4490:9999])", "decimal", [("CG202", "ds[4490:9999]")]),
        ("SUM(ds[0:9999])", "decimal", [("CG202", "ds[0:9999]")]),
        ("SUM(ds[ds.A:ds.B])", "decimal", [("CG202", "ds[ds.A:ds.B]")]),
        ('SUM(ds["A":5])', "decimal", [("CG202", 'ds["A":5]')]),
        ("ds[1:5] + 1", "decimal", [("CG116", "ds[1:5]")]),
        ("SUM((ds[1:5]))", "decimal", [("CG116", "SUM((ds[1:5]))")]),
        ("SUM(ds.A) + SUM(ds[1:2], 5)", "decimal", [("CG116", "SUM(ds[1:2], 5)")]),
        # pointers
        ("ds[dd.Index]", "decimal", [("CG212", "dd.Index")]),
        ("x[ds.Index] + sd[dh[1]]", "decimal", [("CG213", "x[ds.Index]"), ("CG212", "dh[1]")]),
        ("ds[ds[ds.A]] + ds[ds[1:5]]", "decimal", [("CG212", "ds[ds.A]"), ("CG212", "ds[1:5]")]),
        # the other mode's words
        ("dh.A AND dh.B", "decimal", [("CG117", "AND")]),
        ("NOT ds.A shl 2", "decimal", [("CG117", "NOT"), ("CG117", "shl")]),
        ("RSH(ds.A, 2)", "decimal", [("CG117", "RSH")]),
        ("dh.A ^ 2 + sin(dh.B) + PI", "hex", [("CG117", "^"), ("CG117", "sin"), ("CG117", "PI")]),
        # functions
        ("SQR(2) + SINE(2) + foo(2)", "decimal", [("CG117", "SQR"), ("CG117", "SINE"), ("CG117", "foo")]),
        ("SIN(1, 2) + SIN * 2", "decimal", [("CG116", "SIN(1, 2)"), ("CG116", "SIN")]),
        ("LSH(dh.A) + ROL(dh.A, 1)", "hex", [("CG116", "LSH(dh.A)"), ("CG117", "ROL")]),
        ('"text" + 1', "decimal", [("CG116", '"text"')]),
        # numbers
        ("ds.A + 0x00FF + FFh", "decimal", [("CG309", "0x00FF"), ("CG309", "FFh")]),
        ("0x10000 + 65536 + 1.5", "hex", [("CG302", "0x10000"), ("CG302", "65536"), ("CG302", "1.5")]),
        ("1e39 + 1e-39 + 1e999999", "decimal", [("CG302", "1e39"), ("CG302", "1e-39"), ("CG302", "1e999999")]),
        ("2147483648", "decimal", [("CG302", "2147483648")]),
        # a problem reported before a syntax error stays
        ("di.A + ds[0] + ", "decimal", [("CG113", "di"), ("CG201", "ds[0]"), ("CG116", "+")]),
    ],
)
def test_mistakes_at_their_place(source: str, mode: Mode, expected: list[tuple[str, str]]) -> None:
    assert mistakes(source, mode) == expected


@pytest.mark.parametrize(
    ("source", "mode", "help"),
    [
        ("ds[5000]", "decimal", "1..4500"),
        ("xd[9]", "decimal", 'xd["0u"]'),
        ("dss.A", "decimal", "did you mean ds?"),
        ("DS5", "decimal", "write ds[5]"),
        ("XD0u", "decimal", 'write xd["0u"]'),
        ("ds[10h]", "decimal", "write ds[16]"),
        ("SINE(2)", "decimal", "write SIN(2): a sine"),
        ("POW(ds.A, 2)", "decimal", "write (ds.A ^ 2)"),
        ("dh.A AND 5", "decimal", "math_hex"),
        ("SIN(dh.A)", "hex", "calc"),
        ("0xFF", "decimal", "write 255"),
        ("SUM(DS1:DS10)", "decimal", "SUM(ds[1:11])"),
        ("ds[1:5]", "decimal", "SUM(ds[1:5])"),
        ("SUM(ds[5:5])", "decimal", "ds[5:6] is one address"),
        ("ds.My Name", "decimal", 'ds["Any name"]'),
        ("dh.A & 1", "decimal", "math_hex"),
        ("ds.A ** 2", "decimal", "write ^"),
    ],
)
def test_way_out(source: str, mode: Mode, help: str) -> None:
    _, found = read(source, mode)
    assert help in found[0].help


def test_every_mistake_tells_its_examples(monkeypatch: pytest.MonkeyPatch) -> None:
    told: list[object] = []
    find = explaining.find_mistake

    def spy(situation: str, found: str, before: str, touching: bool) -> object:
        told.append(find(situation, found, before, touching))  # type: ignore[arg-type]
        return told[-1]

    monkeypatch.setattr(explaining, "find_mistake", spy)
    for mistake in MISTAKES:
        for example in mistake.examples:
            told.clear()
            _, found = read(example, "decimal")
            assert told == [mistake], (example, found)
            assert [problem.code for problem in found][-1] == "CG116", example


def test_only_the_last_resorts_have_no_example() -> None:
    assert [mistake.found for mistake in MISTAKES if not mistake.examples] == [(), ()]


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("sign", SPELLINGS)
def test_every_spelling_tells_its_examples(sign: str, mode: Mode) -> None:
    spelling = SPELLINGS[sign]
    for example in spelling.examples:
        _, found = read(example, mode)
        assert found[-1].code == "CG116"
        assert found[-1].message.startswith(spelling.message)
        assert shown(example, found[-1]) == sign
        assert spelling.operator in found[-1].message
        assert found[-1].help


@pytest.mark.parametrize("source", ["@", "ds.A ? 2", "ds.A \\ 2", "a;b", "\x00", "\ud800", "ds.A + \U0001f600"])
def test_unreadable_characters(source: str) -> None:
    codes = [problem.code for problem in read(source, "decimal")[1]]
    assert codes[-1] == "CG116"


def test_references_carry_spans() -> None:
    source = 'ds.Name + ds[5] * xd["0u"] - dd[ds.I] + SUM(dd[1:4])'
    formula, _ = read(source, "decimal")
    assert formula is not None
    found = references(formula)
    assert [source[node.start : node.end] for node in found] == [
        "ds.Name",
        "ds[5]",
        'xd["0u"]',
        "dd[ds.I]",
        "SUM(dd[1:4])",
    ]
    refs = [node.range if isinstance(node, Sum) else node.ref for node in found]
    text = embed(source)
    assert refs[0] == Named("DS", "Name", text.span(0, 7))
    assert refs[1] == Cell(Address("DS", 5), text.span(10, 15))
    assert refs[2] == Cell(Address("XD", 0, True), text.span(18, 26))
    assert refs[3] == Pointer("DD", Named("DS", "I", text.span(32, 36)), text.span(29, 37))
    assert refs[4] == Range("DD", 1, 3, text.span(44, 51))
    assert isinstance(found[0], Operand)


def test_place_inside_joined_and_escaped_literals() -> None:
    source = SourceFile("prog.py", "calc('ds.A \\x2b '\n     'ds[0]', ds.B)")
    text = embedded_text(source, [("'ds.A \\x2b '", 1, 6), ("'ds[0]'", 2, 6)], "ds.A + ds[0]")
    problems = Diagnostics()
    assert parse_formula(text, "decimal", problems) is None
    assert [str(problem.span) for problem in problems.found] == ["prog.py:2:7"]


# -- limits -----------------------------------------------------------------------------------------------------------


def test_nesting_as_written() -> None:
    assert click("(" * 8 + "ds.A" + ")" * 8)
    assert mistakes("(" * 9 + "ds.A" + ")" * 9) == [("CG310", "(")]
    assert click("+".join(["(ds.A)"] * 60)).count("(") == 60


def test_nesting_as_printed() -> None:
    assert click("-" * 9 + "ds.A").count("(") == 8
    source = "-" * 10 + "ds.A"
    assert mistakes(source) == [("CG310", source)]
    chain = "2 ^ " * 9 + "2"
    assert click(chain).count("(") == 8
    assert mistakes("2 ^ " + chain) == [("CG310", "2 ^ " + chain)]


def test_operand_count() -> None:
    assert click(" + ".join(["ds.A"] * 68))
    assert mistakes(" + ".join(["ds.A"] * 68 + ["ds.Last", "1"])) == [("CG311", "ds.Last")]
    # The zeros of CLICK's 0 - x count too.
    assert mistakes(" + ".join(["-ds.A"] * 35))[0][0] == "CG311"


@pytest.mark.parametrize(
    ("source", "code"),
    [
        ("(" * 1999 + "1" + ")" * 1999, "CG310"),
        ("(" * 4000, "CG310"),
        ("-" * 3990 + "1", "CG311"),
        ("NOT " * 900 + "1", "CG117"),
        ("2^" * 1900 + "2", "CG311"),
        ("1+" * 1900 + "1", "CG311"),
        ("ds[" * 1300 + "1" + "]" * 10, "CG212"),
        ("SIN(" * 60 + "1" + ")" * 60, "CG310"),
        ("1" * 3999, "CG302"),
        ("0x" + "F" * 3990, "CG309"),
        ("1 + " * 1001, "CG116"),
        ("w" * 3999, "CG113"),
        ("w" * 2000 + " " + "v" * 1900, "CG116"),
    ],
)
def test_hopeless_formulas_are_told(source: str, code: str) -> None:
    assert read(source, "decimal")[0] is None
    found = {problem.code for problem in read(source, "decimal")[1]}
    assert code in found
    assert all(len(problem.message) < 200 for problem in read(source, "decimal")[1])


# -- the grammar ------------------------------------------------------------------------------------------------------


def test_every_rule_has_its_method_and_every_method_its_rule() -> None:
    rules = {rule.alias or rule.origin.name for rule in reader().lark.rules if not rule.options.expand1 or rule.alias}
    methods = {name for name in vars(Builder) if not name.startswith("_")} - {"begin", "finish"}
    assert {str(rule) for rule in rules if not str(rule).startswith("_")} == methods


def test_operator_words_are_declared() -> None:
    declared = re.search(r"^%declare (.*)$", grammar_text(), re.MULTILINE)
    assert declared is not None
    assert set(declared.group(1).split()) == set(TERMINAL.values())


def test_grammar_is_found_in_a_wheel_and_in_a_checkout(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    package = tmp_path / "clickgen"
    for folder in (tmp_path / "grammar", package / "grammar"):
        folder.mkdir(parents=True)
        (folder / "formula.lark").write_text(folder.parent.name)
        monkeypatch.setattr(clickgen, "__file__", str(package / "__init__.py"))
        assert grammar_text() == folder.parent.name


def test_print_source() -> None:
    formula, _ = read("-(ds.A+1.50)*pi + ds[ds[5]] + SUM(ds[1:4])*ds['Any name']", "decimal")
    assert formula is not None
    assert print_source(formula) == '-(ds.A + 1.50) * PI + ds[ds[5]] + SUM(ds[1:4]) * ds["Any name"]'
    formula, _ = read("not dh.A shl 10h", "hex")
    assert formula is not None
    assert print_source(formula) == "LSH(NOT dh.A, 0x10)"
