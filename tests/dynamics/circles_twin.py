"""Where ways meet circles, as the slow twin of the stepped rule sees it."""

import math


def enter(d, a, reach):
    """Part of a way from a by d at which it enters a circle around zero."""
    c = a[0] * a[0] + a[1] * a[1] - reach * reach
    if c <= 0.0:
        return 0.0
    b, square = a[0] * d[0] + a[1] * d[1], d[0] * d[0] + d[1] * d[1]
    inside = b * b - square * c
    if b >= 0.0 or inside <= 0.0:
        return math.inf
    part = c / (math.sqrt(inside) - b)
    return part if part <= 1.0 else math.inf


def leave(d, a, room):
    """Part of a way from a by d at which it leaves a circle around zero."""
    c = room * room - a[0] * a[0] - a[1] * a[1]
    b, square = a[0] * d[0] + a[1] * d[1], d[0] * d[0] + d[1] * d[1]
    inside = b * b + square * c
    if square == 0.0 or inside <= 0.0 or (c <= 0.0 and b >= 0.0):
        return 0.0
    root = math.sqrt(inside)
    return min(c / (b + root) if b > 0.0 else (root - b) / square, 1.0)
