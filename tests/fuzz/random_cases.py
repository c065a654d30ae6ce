"""The random cases of all operations: a case depends on its seed and number alone."""

import random

import kinds
import shapes

OPERATIONS = ("adaptive", *kinds.KINDS)


def random_case(operation, pick, number):
    """A case of a shape that the operation clears; None where the shape came out unusable."""
    if operation == "adaptive":
        return shapes.case(pick, number)
    of_kinds = kinds.KINDS[operation]
    kind = of_kinds[number % len(of_kinds)]
    outer, islands, is_open = kind(pick)
    name = "fuzz_%s_%s_%05d" % (operation.split("_")[0], kind.__name__, number)
    case = {**shapes.case_of(name, outer, islands, pick), "operation": operation}
    return {**case, "open": True} if is_open else case


def cases(seed, first, operation="adaptive"):
    """(number, case) without end; a case depends on the seed and its number alone. Each second one
    has choices beside the pocket.
    """
    import choices

    number = first
    while True:
        case = random_case(operation, random.Random("%d/%d" % (seed, number)), number)
        if case is not None:
            case["name"] += "_s%d" % seed
            if number % 2:
                choices.choose(random.Random("%d/%d/choices" % (seed, number)), case)
            yield number, case
        number += 1
