"""Counter-based random numbers: the same key and counter give the same numbers, whoever asks, and whenever.

Philox with four words of 32 bits and ten rounds, in 64-bit integers that never overflow.

Source: J. K. Salmon et al., Parallel random numbers: as easy as 1, 2, 3, SC11 (2011), doi:10.1145/2063384.2063405.
"""

from __future__ import annotations

import math

from gasbox.jit import bare_kernel, inlined_kernel

__all__ = ["philox", "time_words", "uniform"]

_WORD = 0xFFFFFFFF


@inlined_kernel
def _product(a: int, b: int) -> tuple[int, int]:
    """High and low word of the product of two words."""
    low = (a & 0xFFFF) * b
    high = (a >> 16) * b + (low >> 16)
    return high >> 16, ((high & 0xFFFF) << 16) | (low & 0xFFFF)


@bare_kernel
def philox(c0: int, c1: int, c2: int, c3: int, k0: int, k1: int) -> tuple[int, int, int, int]:
    """Four random words from four words of counter and two of key."""
    for _ in range(10):
        high_0, low_0 = _product(0xD2511F53, c0)
        high_1, low_1 = _product(0xCD9E8D57, c2)
        c0, c1, c2, c3 = (high_1 ^ c1 ^ k0), low_1, (high_0 ^ c3 ^ k1), low_0
        k0 = (k0 + 0x9E3779B9) & _WORD
        k1 = (k1 + 0xBB67AE85) & _WORD
    return c0, c1, c2, c3


@inlined_kernel
def uniform(word: int, other: int) -> float:
    """A number in (0, 1) from two random words."""
    return (word * 2097152.0 + (other >> 11) + 0.5) * (1.0 / 9007199254740992.0)


@inlined_kernel
def time_words(time: float) -> tuple[int, int]:
    """Two words that tell one floating-point time from another."""
    share, power = math.frexp(time)
    bits = int(share * 9007199254740992.0)
    return bits & _WORD, ((bits >> 32) ^ (power << 22)) & _WORD
