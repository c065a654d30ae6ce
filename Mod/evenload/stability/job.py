"""What macros need of stability, together: reading, judging, choosing and taking a cut."""

from evenload.stability.choice import best_of
from evenload.stability.field import levels
from evenload.stability.operation import PROPERTY, keep, kept, of, read
from evenload.stability.picture import save as save_picture
from evenload.stability.taking import take

__all__ = ["PROPERTY", "best_of", "keep", "kept", "levels", "of", "read", "save_picture", "take"]
