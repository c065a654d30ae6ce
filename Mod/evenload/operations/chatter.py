"""What an operation's Report says of chatter, where its tool controller knows what vibrates."""

from evenload.stability import operation as stability


def notes(obj):
    """Sentences: a warning where the operation is unstable, or why that cannot be told. Asks
    `waiting` whether to go on, and raises waiting.Stopped.
    """
    if not getattr(obj.ToolController, stability.PROPERTY, ""):
        return []
    try:
        verdict = stability.of(obj)
    except ValueError as error:
        return ["Whether the cut is stable is not known: %s" % error]
    return [] if verdict.is_stable else [verdict.sentence]
