"""Worlds: rules on top of a gas, built on what is public alone. Contacts and the state in, changes out."""

from gasbox.worlds.demon import MaxwellsDemon
from gasbox.worlds.epidemic import Outbreak
from gasbox.worlds.pong import PongGame
from gasbox.worlds.replies import Replies

__all__ = ["MaxwellsDemon", "Outbreak", "PongGame", "Replies"]
