"""Pong in a gas: who hits the ball, who lets it pass, and where the bats go."""

from gasbox.worlds.pong.game import PongGame

__all__ = ["PongGame"]
