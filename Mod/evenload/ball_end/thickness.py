"""The mean thickness of chips as a polynomial, for as many places as a path has.

One chip takes a millisecond, and a path has tens of thousands of places, at each of which the feed
is sought. So some hundred chips of the path's own places are computed, at several feeds, and a
polynomial of third degree is fitted to the logarithm of their mean thickness. Needs no FreeCAD.
"""

import itertools
from dataclasses import dataclass

import numpy

from evenload import waiting
from evenload.ball_end.chips import chips
from evenload.ball_end.loads import possible

DEGREE = 3
CHIPS_PER_TERM = 3
SEED = 1  # so that the same path gets the same feeds
BESIDE = 0.08  # chips' curvatures, as shares of the ball's, and stepovers beside those of a place
NEAR = 0.7  # of the logarithm: chips whose thickness is as far from the wish weigh half
HALVINGS = 40  # of the range of feeds
HOLLOW, SHARP = -0.6, 10.0  # ball's radius over the least radius of curvature: what is let in


@dataclass(frozen=True)
class Surroundings:
    """What n places' chips depend on, in the frame of the feed. bends: n x 2 x 2, 1/mm, of the
    surface, along the feed and to its left, > 0 convex; stepovers: mm along the surface of the
    ball's centres, infinite in a slot; uncut: as in ball_end.chip, the same for all.
    """

    bends: numpy.ndarray
    stepovers: numpy.ndarray
    uncut: str


def feeds_for(wanted, around, ball, feeds):
    """mm per tooth at which the chips of n places have the mean thickness `wanted`, mm, within the
    limits `feeds`, (low, high).

    ball: a loads.Cutting. Asks waiting.go_on. Raises ValueError where there are no such chips.
    """
    low, high = numpy.log(feeds)
    radius = ball.diameter / 2
    samples, logs = _samples(around, radius, low, high)
    thickness, kept = _mean_thickness(samples, ball, numpy.exp(logs))
    known = _variables(samples, radius)[kept]
    middle, half = (known.min(axis=0) + known.max(axis=0)) / 2, numpy.ptp(known, axis=0) / 2
    scaled = numpy.clip((_variables(around, radius) - middle) / half, -1, 1)
    feed = (logs[kept] - (low + high) / 2) / ((high - low) / 2)
    powers = _powers(1 + len(middle))
    terms = _terms(numpy.column_stack([feed, (known - middle) / half]), powers)
    off = numpy.log(thickness / wanted)
    weights = 1 / (1 + (off / NEAR) ** 2)
    factors = numpy.linalg.lstsq(weights[:, None] * terms, weights * off, rcond=1e-9)[0]
    # Of each place the factors of the feed's powers alone.
    of_feed = numpy.column_stack(
        [
            _terms(scaled, powers[powers[:, 0] == n, 1:]) @ factors[powers[:, 0] == n]
            for n in range(DEGREE + 1)
        ]
    )
    found = _where_nothing(of_feed)
    return numpy.exp((low + high) / 2 + found * (high - low) / 2)


def _where_nothing(factors):
    """Between -1 and 1, where n polynomials that grow, told by their factors, are 0."""
    low, high = -numpy.ones(len(factors)), numpy.ones(len(factors))
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        reached = factors[:, -1]
        for n in range(DEGREE - 1, -1, -1):
            reached = reached * middle + factors[:, n]
        low = numpy.where(reached < 0, middle, low)
        high = numpy.where(reached < 0, high, middle)
    return (low + high) / 2


def _variables(around, radius):
    """n x 4, or 3 in a slot: bounded curvatures along the feed, across it and the twist, as shares
    of the ball's, and the logarithm of the stepover."""
    values, vectors = _principal(around.bends * radius)
    bounded = values / numpy.sqrt(1 + values**2)
    bends = numpy.einsum("nik,nk,njk->nij", vectors, bounded, vectors)
    columns = [bends[:, 0, 0], bends[:, 1, 1], bends[:, 0, 1]]
    if around.uncut != "slot":
        columns.append(numpy.log(around.stepovers))
    return numpy.column_stack(columns)


def _principal(bends):
    values, vectors = numpy.linalg.eigh(bends)
    return numpy.clip(values, HOLLOW, SHARP), vectors


def _samples(around, radius, low, high):
    """(Surroundings, logarithms of feeds) of the chips that are computed: about those of some of
    the places, since what all places have in common would leave the polynomial open beside it.
    """
    columns = 3 if around.uncut == "slot" else 4
    count = CHIPS_PER_TERM * len(_powers(1 + columns))
    chance = numpy.random.default_rng(SEED).random((count, 6))
    rows = (chance[:, 0] * len(around.bends)).astype(int)
    aside = BESIDE / radius * (2 * chance[:, 1:4] - 1)
    bends = around.bends[rows] + aside[:, [0, 1, 1, 2]].reshape(-1, 2, 2)
    stepovers = around.stepovers[rows] * numpy.exp(BESIDE * (2 * chance[:, 4] - 1))
    return Surroundings(bends, stepovers, around.uncut), low + (high - low) * chance[:, 5]


def _mean_thickness(around, ball, feeds):
    """(mm, which of the places have a chip)."""
    values, vectors = _principal(around.bends * ball.diameter / 2)
    surfaces = [("patch", *row) for row in (values / (ball.diameter / 2)).tolist()]
    # The feed seen from the first principal direction.
    directions = numpy.degrees(numpy.arctan2(-vectors[:, 1, 0], vectors[:, 0, 0]))
    # A slot has no pass beside it: any stepover will do.
    steps = numpy.where(numpy.isfinite(around.stepovers), around.stepovers, ball.stock)

    def chips_of(rows):
        waiting.go_on()
        return chips(
            [surfaces[row] for row in rows],
            *(ball.diameter, feeds[rows], steps[rows], ball.stock, directions[rows]),
            *(0, around.uncut, "centre"),
        )

    refusals = []
    parts = list(possible(chips_of, numpy.arange(len(surfaces)), refusals))
    if not parts:
        raise ValueError(refusals[0])
    kept = numpy.concatenate([rows for rows, _ in parts])
    return numpy.concatenate([chip.mean_thickness for _, chip in parts]), kept


def _powers(count):
    """The powers of `count` variables in the terms of a polynomial, of the first one first."""
    rows = itertools.product(range(DEGREE + 1), repeat=count)
    return numpy.array([row for row in rows if sum(row) <= DEGREE])


def _terms(variables, powers):
    """The values of terms, n x as many as there are."""
    steps = [numpy.ones_like(variables)]
    for _ in range(DEGREE):
        steps.append(steps[-1] * variables)
    steps = numpy.array(steps)  # power, place, variable
    result = numpy.ones((len(variables), len(powers)))
    for column in range(variables.shape[1]):
        result *= steps[powers[:, column], :, column].T
    return result
