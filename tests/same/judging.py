"""What this tree's core does for both: what a larger tool left, and the simulator's verdict."""

TOP = 0.0  # mm, of the stock in all cases


def standing_of(case):
    """{"standing": [(outer, islands)], as chains} of what a larger tool left, None without one; or
    {"refused": why} where that tool cannot clear the pocket or leaves nothing.
    """
    import choices
    import figures

    if "rest_of" not in case:
        return {"standing": None}
    try:
        given, _ = choices.given_and_scene(case, figures.RESOLUTION)
    except choices.NothingLeft:
        return {"refused": "nothing is left"}
    except (RuntimeError, ValueError) as error:
        return {"refused": str(error)}
    (level,) = given["stock"]
    return {"standing": [(piece.outer, piece.islands) for piece in level]}


def judged(case, results, closely):
    """The figures of each of what `clearing.cleared` returned for a case, in order; {} of an error
    or of no path. A figure that does not apply to one of them is in none.
    """
    import choices
    import figures

    if not any(result.get("moves") for result in results):
        return [{} for _ in results]
    resolution = figures.FINEST if closely else figures.resolution_for(case)
    step = figures.CLOSE_STEP if closely else figures.STEP
    _, scene = choices.given_and_scene(case, resolution)
    found = [seen(case, result, scene, step) for result in results]
    apply = that_apply(case, results, found)
    return [{name: each[name] for name in apply if name in each} for each in found]


def that_apply(case, results, found):
    """The names of all figures that apply."""
    import choices
    import fuzz

    limits = fuzz.LIMITS
    for result in results:
        limits = choices.limits_for(case, result.get("findings", ()), limits)
    without = set(fuzz.LIMITS) - set(limits)
    return [name for name in max(found, key=len) if name not in without]


def is_unsure(found):
    """Whether a mean of one is above its limit: then all are looked at closely, as fuzz does, and
    stay comparable.
    """
    import figures
    import fuzz

    return any(each.get(name, 0.0) > fuzz.LIMITS[name] for each in found for name in figures.MEANS)


def seen(case, result, scene, step):
    """fuzz's figures, and retracts and blocks per metre."""
    import evenload
    import figures
    import path_laws

    moves = result.get("moves")
    if not moves:
        return {}
    run = evenload.simulate(moves, **scene, step=step)
    return {
        **figures.figures_of(case, moves, run),
        "retracts": retracts(moves),
        "blocks": path_laws.blocks_per_metre(run, moves),
    }


def retracts(moves):
    """How often the tool rises out of the stock and comes back."""
    heights = [move[3] for move in moves]
    rises = sum(before < TOP <= after for before, after in zip(heights, heights[1:]))
    return max(0, rises - 1)
