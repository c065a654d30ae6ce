"""Whether settings are within the ranges of their rows."""


def check(obj, settings):
    """Raises ValueError with a sentence for the first of an operation's settings that is not."""
    for row in settings:
        refusal = row.range.refusal(row.of(obj)) if row.range else None
        if refusal:
            raise ValueError("%s is %s: it %s." % (row.name, row.told(obj), refusal))
