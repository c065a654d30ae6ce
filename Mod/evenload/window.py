"""FreeCAD's window, as operations see it. Without a GUI there is none, and nothing is shown; with
one, `evenload.gui` says here how things are shown, so that operations need not know of it.
"""

show = None  # callable(operation): gives it and its job the view providers that they lack
watch = None  # callable(title) -> a context with a callable(share) -> whether to go on
