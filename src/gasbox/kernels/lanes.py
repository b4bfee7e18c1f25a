"""Eight numbers at a time: vectors of a fixed width that kernels compute with as with single ones.

numba leaves it to the compiler whether a loop is turned into vector instructions, and a loop over neighbours of a few
rounds never is. Here the width is said: a `Lanes` is one vector register, or two or four on narrower processors, with
the same bits. Kernels write `a * b + c` with lanes as with floats; without the JIT they are NumPy arrays of eight.

    >>> x = load(position, 40)          # position[40:48]
    >>> near = x * x < spread(6.25)
    >>> total(choose(near, x, spread(0.0)))
"""

from __future__ import annotations

import operator
from collections.abc import Callable
from typing import Any, Final

import llvmlite.ir  # type: ignore[import-untyped]
import numba.core.cgutils
import numba.core.datamodel
import numba.core.types
import numba.core.typing.templates
import numba.extending
import numba.np.arrayobj
import numpy as np

from gasbox.jit import is_compiling

__all__ = [
    "WIDTH",
    "Lanes",
    "bits",
    "choose",
    "exponential",
    "load",
    "lowest",
    "root",
    "spread",
    "store",
    "take",
    "total",
]

WIDTH: Final = 8
"""Numbers in a `Lanes`."""

# numba and llvmlite have no types for these parts of themselves.
_types: Any = numba.core.types
_cgutils: Any = numba.core.cgutils
_models: Any = numba.core.datamodel
_templates: Any = numba.core.typing.templates
_extending: Any = numba.extending
_arrays: Any = numba.np.arrayobj
_ir: Any = llvmlite.ir

Lanes = Any
"""Eight numbers, or eight truth values, to a type checker."""

_VECTOR: Final = _ir.VectorType(_ir.DoubleType(), WIDTH)
_TRUTHS: Final = _ir.VectorType(_ir.IntType(1), WIDTH)


class LanesType(_types.Type):  # type: ignore[misc]
    """Eight float64."""

    def __init__(self) -> None:
        super().__init__(name="Lanes")


class MaskType(_types.Type):  # type: ignore[misc]
    """Eight truth values."""

    def __init__(self) -> None:
        super().__init__(name="LanesMask")


_LANES: Final = LanesType()
_MASK: Final = MaskType()


def _register(kind: type, vector: Any) -> None:
    class Model(_models.PrimitiveModel):  # type: ignore[misc]
        def __init__(self, manager: Any, fe_type: Any) -> None:
            super().__init__(manager, fe_type, vector)

    _extending.register_model(kind)(Model)


def _spread(builder: Any, number: Any) -> Any:
    one = builder.insert_element(
        _ir.Constant(_VECTOR, _ir.Undefined), number, _ir.Constant(_ir.IntType(32), 0)
    )
    zeros = _ir.Constant(_ir.VectorType(_ir.IntType(32), WIDTH), [0] * WIDTH)
    return builder.shuffle_vector(one, _ir.Constant(_VECTOR, _ir.Undefined), zeros)


def _as_lanes(context: Any, builder: Any, kind: Any, value: Any) -> Any:
    if kind == _LANES:
        return value
    return _spread(builder, context.cast(builder, value, kind, _types.float64))


def _operator(operation: Callable[..., Any], name: str, compares: bool = False) -> None:
    """Teach numba an operator between lanes, or between lanes and a number."""

    class Template(_templates.AbstractTemplate):  # type: ignore[misc]
        def generic(self, args: Any, kws: Any) -> Any:
            if len(args) == 2 and _LANES in args and all(_is_number(kind) for kind in args):
                return _templates.signature(_MASK if compares else _LANES, *args)
            return None

    _templates.infer_global(operation)(Template)

    def code(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        a, b = (_as_lanes(context, builder, *pair) for pair in zip(signature.args, arguments, strict=True))
        return builder.fcmp_ordered(name, a, b) if compares else getattr(builder, name)(a, b)

    for kinds in ((LanesType, LanesType), (LanesType, _types.Number), (_types.Number, LanesType)):
        _extending.lower_builtin(operation, *kinds)(code)


def _is_number(kind: Any) -> bool:
    return kind == _LANES or isinstance(kind, _types.Number)


def _both() -> None:
    """Teach numba `mask & mask`."""

    class Template(_templates.AbstractTemplate):  # type: ignore[misc]
        def generic(self, args: Any, kws: Any) -> Any:
            return _templates.signature(_MASK, *args) if tuple(args) == (_MASK, _MASK) else None

    _templates.infer_global(operator.and_)(Template)

    @_extending.lower_builtin(operator.and_, MaskType, MaskType)  # type: ignore[untyped-decorator]
    def code(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return builder.and_(*arguments)


_register(LanesType, _VECTOR)
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


def _intrinsic_or(plain: Any) -> Any:
    """Decorator: an intrinsic, or `plain` where kernels are not compiled."""
    return _extending.intrinsic if is_compiling() else lambda _: plain


def _pointer(context: Any, builder: Any, signature: Any, array: Any, place: Any) -> Any:
    kind = signature.args[0]
    index = context.cast(builder, place, signature.args[1], _types.intp)
    return _cgutils.get_item_pointer(
        context, builder, kind, _arrays.make_array(kind)(context, builder, array), [index]
    )


@_intrinsic_or(lambda number: np.full(WIDTH, number))  # type: ignore[untyped-decorator]
def spread(_: Any, number: Any) -> Any:
    """The same number in all lanes."""

    def code(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return _as_lanes(context, builder, signature.args[0], arguments[0])

    return _LANES(number), code


@_intrinsic_or(lambda array, place: array[place : place + WIDTH].copy())  # type: ignore[untyped-decorator]
def load(_: Any, array: Any, place: Any) -> Any:
    """array[place : place + WIDTH] of a one-dimensional contiguous array of float64.

    Precondition: all of it exists.
    """

    def code(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        pointer = builder.bitcast(_pointer(context, builder, signature, *arguments), _VECTOR.as_pointer())
        return builder.load(pointer, align=8)

    return _LANES(array, place), code


def _store_plain(array: Any, place: int, lanes: Any) -> None:
    array[place : place + WIDTH] = lanes


@_intrinsic_or(_store_plain)  # type: ignore[untyped-decorator]
def store(_: Any, array: Any, place: Any, lanes: Any) -> Any:
    """array[place : place + WIDTH] = lanes. Precondition: as for `load`."""

    def code(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        pointer = _pointer(context, builder, signature, *arguments[:2])
        builder.store(arguments[2], builder.bitcast(pointer, _VECTOR.as_pointer()), align=8)
        return context.get_dummy_value()

    return _types.void(array, place, lanes), code


@_intrinsic_or(lambda table, kinds, place: table[kinds[place : place + WIDTH]])  # type: ignore[untyped-decorator]
def take(_: Any, table: Any, kinds: Any, place: Any) -> Any:
    """table[kinds[place + lane]] in each lane; `kinds` is an array of integers, `table` of float64."""

    def code(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        table, kinds, place = arguments
        integer = signature.args[1].dtype
        place = context.cast(builder, place, signature.args[2], _types.intp)
        lanes = _ir.Constant(_VECTOR, _ir.Undefined)
        array = _arrays.make_array(signature.args[0])(context, builder, table)
        listed = _arrays.make_array(signature.args[1])(context, builder, kinds)
        for lane in range(WIDTH):
            index = builder.add(place, context.get_constant(_types.intp, lane))
            pointer = _cgutils.get_item_pointer(context, builder, signature.args[1], listed, [index])
            kind = context.cast(builder, builder.load(pointer), integer, _types.intp)
            pointer = _cgutils.get_item_pointer(context, builder, signature.args[0], array, [kind])
            lanes = builder.insert_element(lanes, builder.load(pointer), _ir.Constant(_ir.IntType(32), lane))
        return lanes

    return _LANES(table, kinds, place), code


@_intrinsic_or(np.where)  # type: ignore[untyped-decorator]
def choose(_: Any, mask: Any, a: Any, b: Any) -> Any:
    """In each lane `a` where the mask is true, otherwise `b`."""

    def code(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return builder.select(*arguments)

    return _LANES(mask, a, b), code


def _bits_of(mask: Any) -> int:
    return sum(1 << lane for lane in range(WIDTH) if mask[lane])


@_intrinsic_or(_bits_of)  # type: ignore[untyped-decorator]
def bits(_: Any, mask: Any) -> Any:
    """The truth values as the bits of a whole number, the first lane in the lowest."""

    def code(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return builder.zext(builder.bitcast(arguments[0], _ir.IntType(WIDTH)), _ir.IntType(64))

    return _types.int64(mask), code


def _lowest(number: int) -> int:
    return (number & -number).bit_length() - 1


@_intrinsic_or(_lowest)  # type: ignore[untyped-decorator]
def lowest(_: Any, number: Any) -> Any:
    """Place of the lowest bit that is set. Precondition: there is one."""

    def code(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return builder.cttz(arguments[0], _ir.Constant(_ir.IntType(1), 0))

    return _types.int64(_types.int64), code


def _sum_of(lanes: Any) -> float:
    """The sum in the order in which the compiled one is taken: halves are folded on each other."""
    while len(lanes) > 1:
        half = len(lanes) // 2
        lanes = lanes[:half] + lanes[half:]
    return float(lanes[0])


@_intrinsic_or(_sum_of)  # type: ignore[untyped-decorator]
def total(_: Any, lanes: Any) -> Any:
    """Sum of all lanes, in a fixed order: halves are folded on each other."""

    def code(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        value, width = arguments[0], WIDTH
        number = _ir.IntType(32)
        while width > 1:
            half = width // 2
            parts = [
                builder.shuffle_vector(
                    value,
                    _ir.Constant(value.type, _ir.Undefined),
                    _ir.Constant(_ir.VectorType(number, half), list(range(begin, begin + half))),
                )
                for begin in (0, half)
            ]
            value, width = builder.fadd(*parts), half
        return builder.extract_element(value, _ir.Constant(number, 0))

    return _types.float64(lanes), code


def _function(name: str, plain: Any) -> Any:
    """An intrinsic of LLVM, in each lane."""

    @_intrinsic_or(plain)  # type: ignore[untyped-decorator]
    def apply(_: Any, lanes: Any) -> Any:
        def code(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            kind = _ir.FunctionType(_VECTOR, [_VECTOR])
            function = _cgutils.get_or_insert_function(builder.module, kind, f"llvm.{name}.v{WIDTH}f64")
            return builder.call(function, arguments)

        return _LANES(lanes), code

    return apply


root: Any = _function("sqrt", np.sqrt)
"""Square root in each lane."""
exponential: Any = _function("exp", np.exp)
"""Exponential function in each lane."""
