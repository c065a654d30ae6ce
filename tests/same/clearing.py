"""What is asked of a core, this tree's or that of another revision, in a process of its own.

A revision gives its compiled module alone; all Python is this tree's. So this file, `posted` and
`pocket_case` are what must still be understood by older revisions. Where a parameter of the core
gets another name, its former one goes into FORMER_NAMES.
"""

import hashlib
import importlib.util
import re
import sys
import time

FORMER_NOTES = {  # words of a note, and the code of the finding that says the same
    "Cut at reduced feed": "passage_reduced",
    "does not hold the pre-drilled hole, was left uncut": "region_without_hole",
}
FORMER_NAMES = {}  # parameter of this tree's pocket_case -> its name where docs do not have that


def take_core(folder):
    """Makes the module _core in a folder that of this process, which must have none yet."""
    import sysconfig

    import evenload

    name = "evenload._core"
    if name in sys.modules:
        raise RuntimeError("This process has a core already: %s." % sys.modules[name].__file__)
    file = "%s/_core%s" % (folder, sysconfig.get_config_var("EXT_SUFFIX"))
    spec = importlib.util.spec_from_file_location(name, file)
    core = importlib.util.module_from_spec(spec)
    sys.modules[name] = evenload._core = core
    spec.loader.exec_module(core)


def core_file():
    from evenload import _core

    return _core.__file__


def cleared(case, standing):
    """What the core makes of a case: {"exact": digest of the moves to the last bit, "program":
    lines of G-code, "moves": as posted, "findings": codes, "seconds": of the processor}, or
    {"error"}.

    standing: [(outer, islands)] of what a larger tool left, None without one.
    """
    import pocket_case
    from evenload import _core
    from posted import posted

    generate = pocket_case.GENERATORS[case.get("operation", "adaptive")]
    start = time.process_time()
    try:
        given = {}
        if standing is not None:
            given["stock"] = [[_core.Region(*chains) for chains in standing]]
        path = pocket_case.path_of(case, as_it_calls(generate, clearing_docs(_core)), **given)
    except (RuntimeError, TypeError, ValueError) as error:
        return {"error": "%s: %s" % (type(error).__name__, error)}
    seconds = time.process_time() - start
    return {
        "exact": hashlib.sha256(repr(path.moves).encode()).hexdigest(),
        "program": program(_core.path_commands(path)) if path.moves else [],
        "moves": posted(path.moves),
        "findings": codes_of(path.report),
        "seconds": seconds,
    }


def codes_of(report):
    """The codes of a report's findings. Cores before there were codes say notes in words, of which
    those are told apart that the judge goes by.
    """
    if hasattr(report, "findings"):
        return [code for code, _, _ in report.findings]
    return [code for note in report.notes for words, code in FORMER_NOTES.items() if words in note]


def clearing_docs(core):
    """Where the core says what the parameters of its generators are called."""
    return core.clear_pocket.__doc__ or ""


def as_it_calls(generate, docs):
    """The generator with parameters by the names that the docs have."""

    def called(*regions, **parameters):
        return generate(*regions, **{name_in(docs, key): parameters[key] for key in parameters})

    return called


def name_in(docs, name):
    known = name not in FORMER_NAMES or re.search(r"\b%s\b" % name, docs)
    return name if known else FORMER_NAMES[name]


def program(commands):
    """Lines of G-code, of as many decimals as posts write."""
    return [
        " ".join([name, *("%s%.4f" % (word, value) for word, value in words.items())])
        for name, words in commands
    ]
