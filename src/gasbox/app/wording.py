"""Numbers as the page writes them."""

from __future__ import annotations

import math

__all__ = ["number", "times", "whole"]

_SUPERSCRIPT = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
_NOTHING = "–"


def number(value: float | None, digits: int = 3) -> str:
    """A number with a fixed count of significant digits, so that a readout does not change its width all the time.

    Very large and very small ones are written with a power of ten; None and non-finite ones as a dash.
    """
    if value is None or not math.isfinite(value):
        return _NOTHING
    if value == 0:
        return "0"
    exponent = math.floor(math.log10(abs(float(f"{value:.{digits - 1}e}"))))
    if -4 < exponent < 5:
        decimals = max(0, digits - 1 - exponent)
        return f"{value:,.{decimals}f}".replace(",", "\u2009").replace("-", "\u2212")
    mantissa = f"{value:.{digits - 1}e}".partition("e")[0].replace("-", "\u2212")
    return f"{mantissa}×10{str(exponent).translate(_SUPERSCRIPT)}"


def whole(value: int) -> str:
    """An integer with thin spaces between groups of three digits."""
    return f"{value:,}".replace(",", "\u2009")


def times(speed: float) -> str:
    """A speed as a multiple, for example ``0.5×``."""
    return f"{speed:.3g}×"
