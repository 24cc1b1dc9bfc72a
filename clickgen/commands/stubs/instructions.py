"""Each instruction as a function with typed parameters, and the boxes to which inputs are chained."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from clickgen.commands.stubs.arguments import Group, groups, type_of, whole
from clickgen.commands.stubs.text import Argument, Signature, class_text, function_text, overloads_text
from clickgen.device.banks import BANKS, Bank
from clickgen.instructions import INSTRUCTIONS, every
from clickgen.instructions.effects import Flow
from clickgen.instructions.spec import REQUIRED, Param, ParamKind, Spec

BANK_NAMES = tuple(bank.dsl for bank in BANKS.values())


def instruction_functions() -> Iterator[str]:
    """Yield every instruction that is written as a call, each after the class of its inputs."""
    for spec in INSTRUCTIONS.values():
        if spec.pins:
            yield class_text(_box(spec), "", f"The inputs that can be chained after {spec.name}(...).", _methods(spec))
        if spec.name not in BANK_NAMES:
            yield overloads_text(spec.name, _signatures(spec), _returns(spec), _doc(spec))


def call_of_bank(bank: Bank) -> str:
    """The call of a bank that is also an instruction: ``ctd``; "" for any other."""
    spec = INSTRUCTIONS.get(bank.dsl)
    if spec is None:
        return ""
    signatures = [replace(signature, is_method=True) for signature in _signatures(spec)]
    return overloads_text("__call__", signatures, _returns(spec), _doc(spec))


def loop_function() -> str:
    """``range``, which a loop counts with."""
    loop = next(spec for spec in every() if spec.effects.flow is Flow.LOOP)
    count, oneshot = loop.params
    flags = [f"{name}: bool = {oneshot.default}" for name in (oneshot.name, *oneshot.aliases)]
    parameters = [f"{count.name}: {type_of(loop, count)}", "/", "*", *flags]
    return function_text("range", parameters, "Iterable[int]", _doc(loop))


def _doc(spec: Spec) -> str:
    return f"{spec.summary}\n\nExample: {spec.example}\n"


def _returns(spec: Spec) -> str:
    return _box(spec) if spec.pins else "None"


# -- signatures -------------------------------------------------------------------------------------------------------


def _signatures(spec: Spec) -> list[Signature]:
    return [signature for form in spec.forms for signature in _form_signatures(form)]


def _form_signatures(spec: Spec) -> Iterator[Signature]:
    """By the parameters' own names, once for each group of a copy's matrix; then by their other names."""
    for group in groups(spec):
        yield from _without_gaps(_signature(spec, group))
    yield from (_renamed(spec, dict(names)) for names in _other_names(spec))


def _other_names(spec: Spec) -> dict[tuple[tuple[str, str], ...], None]:
    """One parameter by another name, or all that have one. Python cannot say that each goes by any of its names."""
    aliased = [param for param in spec.params if _is_given(param) and param.aliases]
    singly = [((param.name, alias),) for param in aliased for alias in param.aliases]
    most = max((len(param.aliases) for param in aliased), default=0)
    together = [tuple((param.name, (param.aliases * most)[n]) for param in aliased) for n in range(most)]
    return dict.fromkeys((*singly, *together))


def _is_given(param: Param) -> bool:
    return param.default is REQUIRED and param.kind is not ParamKind.PIN


def _signature(spec: Spec, group: Group | None) -> Signature:
    arguments = [Argument(param.name, type_of(spec, param, group), _default(param)) for param in spec.params]
    others = [
        replace(argument, name=alias)
        for param, argument in zip(spec.params, arguments, strict=True)
        if not _is_given(param)
        for alias in param.aliases
    ]
    return Signature(tuple(arguments), tuple(others))


def _default(param: Param) -> str:
    """The default of an argument that is left out; an input may be chained instead."""
    if param.default is REQUIRED:
        return "..." if param.kind is ParamKind.PIN else ""
    return str(param.default)


def _without_gaps(signature: Signature) -> Iterator[Signature]:
    """The signature; if a required parameter follows one with a default, also the form without that one.

    Python can leave out a parameter in the middle only if those after it are named.
    """
    arguments = signature.positional
    last = max((index for index, argument in enumerate(arguments) if not argument.default), default=-1)
    gap = next((index for index, argument in enumerate(arguments[:last]) if argument.default), None)
    if gap is None:
        yield signature
        return
    yield replace(signature, positional=(*(replace(a, default="") for a in arguments[:last]), *arguments[last:]))
    yield Signature(arguments[:gap], (*arguments[gap + 1 :], *signature.named))


def _renamed(spec: Spec, names: dict[str, str]) -> Signature:
    """The signature with other names, the last of which must be written.

    So a call by position never means this one, and the other one reports its mistakes.
    """
    signature = _signature(spec, whole(spec))
    last = max(index for index, param in enumerate(spec.params) if param.name in names)
    arguments = tuple(replace(a, name=names.get(a.name, a.name)) for a in signature.positional)
    return Signature(arguments[:last], (*arguments[last:], *signature.named))


# -- chains -----------------------------------------------------------------------------------------------------------


def _box(spec: Spec) -> str:
    return f"_{spec.name.title().replace('_', '')}Box"


def _methods(spec: Spec) -> Iterator[str]:
    returns = _box(spec) if len(spec.pins) > 1 else "None"
    for method, pin in spec.methods.items():
        own = [param for param in spec.params if param.of_pin == pin.name]
        named = [f"{param.chained}: {type_of(spec, replace(param, default=REQUIRED))}" for param in own]
        parameters = ["self", "condition: _Series", "/", "*more: _Series", *named]
        yield function_text(method, parameters, returns)
