"""Whether two cores made the same of a case."""

EQUAL, DIFFERENT, UNKNOWN = "equal", "different", "unknown"


def verdict(former, present):
    """(EQUAL, DIFFERENT or UNKNOWN, how). Both are what `clearing.cleared` returned, or {"late":
    why} where that took too long, or {"crash": why}. Errors with the same words are equal.
    """
    ends = [end_of(each) for each in (former, present)]
    if all({"late", "crash"} & set(each) for each in (former, present)):
        return UNKNOWN, "%s; now: %s" % tuple(ends)
    if ends[0] or ends[1]:
        same = ends[0] == ends[1]
        return (EQUAL, ends[0]) if same else (DIFFERENT, "%s; now: %s" % tuple(map(words, ends)))
    if former["program"] != present["program"]:
        return DIFFERENT, first_difference(former["program"], present["program"])
    if former["exact"] != present["exact"]:
        return DIFFERENT, "alike as posted, moves differ beyond its decimals"
    return EQUAL, None


def end_of(result):
    """The error, the crash or what took too long; None where there is a path."""
    return result.get("error") or result.get("late") or result.get("crash")


def words(end):
    return end or "a path"


def first_difference(former, present):
    """Where two programs part."""
    for i, (before, now) in enumerate(zip(former, present)):
        if before != now:
            return "from block %d of %d, now of %d" % (i + 1, len(former), len(present))
    return "%d blocks, now %d" % (len(former), len(present))
