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


def judged(case, results):
    """The figures of each of what `clearing.cleared` returned for a case, in order; {} of an error
    or of no path. Where a mean of one is above its limit all are looked at more closely, so that
    they stay comparable. A figure that does not apply to one of them is in none.
    """
    import choices
    import figures
    import fuzz

    if not any(result.get("moves") for result in results):
        return [{} for _ in results]
    limits = fuzz.LIMITS
    for result in results:
        limits = choices.limits_for(case, result.get("notes", ()), limits)
    _, scene = choices.given_and_scene(case, figures.resolution_for(case))
    found = [seen(case, result, scene, figures.STEP) for result in results]
    means = set(figures.MEANS) & set(limits)
    if any(each and each[name] > limits[name] for each in found for name in means):
        if "rest_of" in case:
            _, scene = choices.given_and_scene(case, figures.FINEST)
        scene = {**scene, "resolution": figures.FINEST}
        found = [seen(case, result, scene, figures.CLOSE_STEP) for result in results]
    without = set(fuzz.LIMITS) - set(limits)
    return [{name: each[name] for name in each if name not in without} for each in found]


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
