"""Eight numbers at a time: vectors of a fixed width that kernels compute with as with single ones.

numba leaves it to the compiler whether a loop is turned into vector instructions, and a loop over neighbours of a few
rounds never is. Here the width is said: a `Lanes` is one vector register, or two or four on narrower processors, with
the same bits. Kernels write `a * b + c` with lanes as with floats; without the JIT they are NumPy arrays of eight.

    >>> x = load(position, 40)          # position[40:48]
    >>> near = x * x < spread(6.25)
    >>> total(choose(near, x, spread(0.0)))
"""

from __future__ import annotations

from typing import Any

import llvmlite.ir  # type: ignore[import-untyped]
import numba.core.cgutils
import numba.core.types
import numba.extending
import numba.np.arrayobj
import numpy as np

from gasbox.jit import is_compiling
from gasbox.kernels.lane_types import LANES, VECTOR, WIDTH, as_lanes

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

# numba and llvmlite have no types for these parts of themselves.
_types: Any = numba.core.types
_cgutils: Any = numba.core.cgutils
_extending: Any = numba.extending
_arrays: Any = numba.np.arrayobj
_ir: Any = llvmlite.ir

Lanes = Any
"""Eight numbers, or eight truth values, to a type checker."""


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
        return as_lanes(context, builder, signature.args[0], arguments[0])

    return LANES(number), code


@_intrinsic_or(lambda array, place: array[place : place + WIDTH].copy())  # type: ignore[untyped-decorator]
def load(_: Any, array: Any, place: Any) -> Any:
    """array[place : place + WIDTH] of a one-dimensional contiguous array of float64.

    Precondition: all of it exists.
    """

    def code(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        pointer = builder.bitcast(_pointer(context, builder, signature, *arguments), VECTOR.as_pointer())
        return builder.load(pointer, align=8)

    return LANES(array, place), code


def _store_plain(array: Any, place: int, lanes: Any) -> None:
    array[place : place + WIDTH] = lanes


@_intrinsic_or(_store_plain)  # type: ignore[untyped-decorator]
def store(_: Any, array: Any, place: Any, lanes: Any) -> Any:
    """array[place : place + WIDTH] = lanes. Precondition: as for `load`."""

    def code(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        pointer = _pointer(context, builder, signature, *arguments[:2])
        builder.store(arguments[2], builder.bitcast(pointer, VECTOR.as_pointer()), align=8)
        return context.get_dummy_value()

    return _types.void(array, place, lanes), code


@_intrinsic_or(lambda table, kinds, place: table[kinds[place : place + WIDTH]])  # type: ignore[untyped-decorator]
def take(_: Any, table: Any, kinds: Any, place: Any) -> Any:
    """table[kinds[place + lane]] in each lane; `kinds` is an array of integers, `table` of float64."""

    def code(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        table, kinds, place = arguments
        integer = signature.args[1].dtype
        place = context.cast(builder, place, signature.args[2], _types.intp)
        lanes = _ir.Constant(VECTOR, _ir.Undefined)
        array = _arrays.make_array(signature.args[0])(context, builder, table)
        listed = _arrays.make_array(signature.args[1])(context, builder, kinds)
        for lane in range(WIDTH):
            index = builder.add(place, context.get_constant(_types.intp, lane))
            pointer = _cgutils.get_item_pointer(context, builder, signature.args[1], listed, [index])
            kind = context.cast(builder, builder.load(pointer), integer, _types.intp)
            pointer = _cgutils.get_item_pointer(context, builder, signature.args[0], array, [kind])
            lanes = builder.insert_element(lanes, builder.load(pointer), _ir.Constant(_ir.IntType(32), lane))
        return lanes

    return LANES(table, kinds, place), code


@_intrinsic_or(np.where)  # type: ignore[untyped-decorator]
def choose(_: Any, mask: Any, a: Any, b: Any) -> Any:
    """In each lane `a` where the mask is true, otherwise `b`."""

    def code(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return builder.select(*arguments)

    return LANES(mask, a, b), code


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
            kind = _ir.FunctionType(VECTOR, [VECTOR])
            function = _cgutils.get_or_insert_function(builder.module, kind, f"llvm.{name}.v{WIDTH}f64")
            return builder.call(function, arguments)

        return LANES(lanes), code

    return apply


root: Any = _function("sqrt", np.sqrt)
"""Square root in each lane."""
exponential: Any = _function("exp", np.exp)
"""Exponential function in each lane."""
