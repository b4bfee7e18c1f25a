"""The types of `gasbox.kernels.lanes` as numba knows them, and their operators."""

from __future__ import annotations

import operator
from collections.abc import Callable
from typing import Any, Final

import llvmlite.ir  # type: ignore[import-untyped]
import numba.core.datamodel
import numba.core.types
import numba.core.typing.templates
import numba.extending

from gasbox.jit import is_compiling

__all__ = ["LANES", "MASK", "VECTOR", "WIDTH", "as_lanes"]

WIDTH: Final = 8
"""Numbers in a vector."""

# numba and llvmlite have no types for these parts of themselves.
_types: Any = numba.core.types
_models: Any = numba.core.datamodel
_templates: Any = numba.core.typing.templates
_extending: Any = numba.extending
_ir: Any = llvmlite.ir

VECTOR: Final = _ir.VectorType(_ir.DoubleType(), WIDTH)
_TRUTHS: Final = _ir.VectorType(_ir.IntType(1), WIDTH)


class LanesType(_types.Type):  # type: ignore[misc]
    """Eight float64."""

    def __init__(self) -> None:
        super().__init__(name="Lanes")


class MaskType(_types.Type):  # type: ignore[misc]
    """Eight truth values."""

    def __init__(self) -> None:
        super().__init__(name="LanesMask")


LANES: Final = LanesType()
MASK: Final = MaskType()


def _register(kind: type, vector: Any) -> None:
    class Model(_models.PrimitiveModel):  # type: ignore[misc]
        def __init__(self, manager: Any, fe_type: Any) -> None:
            super().__init__(manager, fe_type, vector)

    _extending.register_model(kind)(Model)


def _spread(builder: Any, number: Any) -> Any:
    one = builder.insert_element(
        _ir.Constant(VECTOR, _ir.Undefined), number, _ir.Constant(_ir.IntType(32), 0)
    )
    zeros = _ir.Constant(_ir.VectorType(_ir.IntType(32), WIDTH), [0] * WIDTH)
    return builder.shuffle_vector(one, _ir.Constant(VECTOR, _ir.Undefined), zeros)


def as_lanes(context: Any, builder: Any, kind: Any, value: Any) -> Any:
    """A value of this type, lanes or a number, as lanes."""
    if kind == LANES:
        return value
    return _spread(builder, context.cast(builder, value, kind, _types.float64))


def _operator(operation: Callable[..., Any], name: str, compares: bool = False) -> None:
    """Teach numba an operator between lanes, or between lanes and a number."""

    class Template(_templates.AbstractTemplate):  # type: ignore[misc]
        def generic(self, args: Any, kws: Any) -> Any:
            if len(args) == 2 and LANES in args and all(_is_number(kind) for kind in args):
                return _templates.signature(MASK if compares else LANES, *args)
            return None

    _templates.infer_global(operation)(Template)

    def code(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        a, b = (as_lanes(context, builder, *pair) for pair in zip(signature.args, arguments, strict=True))
        return builder.fcmp_ordered(name, a, b) if compares else getattr(builder, name)(a, b)

    for kinds in ((LanesType, LanesType), (LanesType, _types.Number), (_types.Number, LanesType)):
        _extending.lower_builtin(operation, *kinds)(code)


def _is_number(kind: Any) -> bool:
    return kind == LANES or isinstance(kind, _types.Number)


def _both() -> None:
    """Teach numba `mask & mask`."""

    class Template(_templates.AbstractTemplate):  # type: ignore[misc]
        def generic(self, args: Any, kws: Any) -> Any:
            return _templates.signature(MASK, *args) if tuple(args) == (MASK, MASK) else None

    _templates.infer_global(operator.and_)(Template)

    @_extending.lower_builtin(operator.and_, MaskType, MaskType)  # type: ignore[untyped-decorator]
    def code(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return builder.and_(*arguments)


_register(LanesType, VECTOR)
_register(MaskType, _TRUTHS)
if is_compiling():
    for _operation, _name in (
        (operator.add, "fadd"),
        (operator.sub, "fsub"),
        (operator.mul, "fmul"),
        (operator.truediv, "fdiv"),
    ):
        _operator(_operation, _name)
    _operator(operator.lt, "<", compares=True)
    _operator(operator.gt, ">", compares=True)
    _both()
