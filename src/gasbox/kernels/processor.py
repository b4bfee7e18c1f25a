"""What a kernel needs of the processor and numba has no function for."""

from __future__ import annotations

import sys
from typing import Any

import llvmlite.ir  # type: ignore[import-untyped]
import numba.core.cgutils
import numba.core.types
import numba.extending
import numba.np.arrayobj

from gasbox.jit import is_compiling

__all__ = ["fetch", "offer_processor", "read", "write"]

# numba and llvmlite have no types for these parts of themselves.
_types: Any = numba.core.types
_cgutils: Any = numba.core.cgutils
_ir: Any = llvmlite.ir
_make_array: Any = numba.np.arrayobj.make_array
_intrinsic: Any = numba.extending.intrinsic

offer_processor: Any = _types.ExternalFunction(
    "SwitchToThread" if sys.platform == "win32" else "sched_yield", _types.int32()
)
"""Let another thread of the machine run."""


def _pointer(context: Any, builder: Any, signature: Any, array: Any, place: Any) -> Any:
    kind = signature.args[0]
    index = [context.cast(builder, place, signature.args[1], _types.intp)]
    index += [context.get_constant(_types.intp, 0)] * (kind.ndim - 1)
    return _cgutils.get_item_pointer(
        context, builder, kind, _make_array(kind)(context, builder, array), index
    )


@_intrinsic  # type: ignore[untyped-decorator]
def read(_: Any, flag: Any, place: Any) -> Any:
    """flag[place], and nothing that comes after is read before it."""

    def code(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return builder.load_atomic(_pointer(context, builder, signature, *arguments[:2]), "acquire", 8)

    return _types.int64(flag, place), code


@_intrinsic  # type: ignore[untyped-decorator]
def write(_: Any, flag: Any, place: Any, value: Any) -> Any:
    """flag[place] = value, after all that was written before."""

    def code(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        value = context.cast(builder, arguments[2], signature.args[2], _types.int64)
        builder.store_atomic(value, _pointer(context, builder, signature, *arguments[:2]), "release", 8)
        return context.get_dummy_value()

    return _types.void(flag, place, value), code


def _intrinsic_or(plain: Any) -> Any:
    """Decorator: an intrinsic, or `plain` where kernels are not compiled."""
    return _intrinsic if is_compiling() else lambda _: plain


@_intrinsic_or(lambda array, place: None)  # type: ignore[untyped-decorator]
def fetch(_: Any, array: Any, place: Any) -> Any:
    """Ask for the cache line in which row `place` begins; any place will do, nothing is read."""

    def code(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        byte = _ir.IntType(8).as_pointer()
        pointer = builder.bitcast(_pointer(context, builder, signature, *arguments), byte)
        number = _ir.IntType(32)
        kind = _ir.FunctionType(_ir.VoidType(), [byte, number, number, number])
        prefetch = _cgutils.get_or_insert_function(builder.module, kind, "llvm.prefetch.p0")
        # To read, to be kept in all caches, data.
        builder.call(prefetch, [pointer, number(0), number(3), number(1)])
        return context.get_dummy_value()

    return _types.void(array, place), code
