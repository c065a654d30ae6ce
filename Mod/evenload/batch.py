"""Jobs without a GUI: a job file (JSON) -> G-code, pictures and a JSON report.

    EVENLOAD_JOB=jobs.json freecadcmd Mod/evenload/batch.py
    freecadcmd Mod/evenload/batch.py jobs.json

The job file is described in docs/batch.md. Exit code 0: every job was done; 1: a job failed, the
others were done, or the report could not be written; 2: the job file could not be used.
"""

import contextlib
import functools
import json
import math
import os
import sys
import time

if __name__ != "evenload.batch":  # FreeCAD runs this file as a module of its own
    _folder = os.path.dirname(os.path.abspath(__file__))
    sys.path[:] = [p for p in sys.path if os.path.abspath(p) != _folder]  # our modules' short names
    if os.path.dirname(_folder) not in sys.path:
        sys.path.append(os.path.dirname(_folder))

import FreeCAD  # noqa: E402

from evenload import compiled, report  # noqa: E402

NUMBER = (int, float)
NAME_OR_VALUES = (str, dict)
REQUIRED, OPTIONAL = True, False
FILE_KEYS = {"jobs": (list, REQUIRED), "report": (str, OPTIONAL)}
JOB_KEYS = {
    "name": (str, OPTIONAL),
    "model": (str, REQUIRED),
    "object": (str, OPTIONAL),
    "base": (list, REQUIRED),
    "stock": (dict, OPTIONAL),
    "tool": (dict, REQUIRED),
    "cutting": (dict, REQUIRED),
    "operation": (dict, REQUIRED),
    "simulation": (dict, OPTIONAL),
    "post": (dict, OPTIONAL),
    "output": (dict, REQUIRED),
}
SECTION_KEYS = {
    "stock": {"margin": (NUMBER, OPTIONAL)},
    "tool": {
        "diameter": (NUMBER, REQUIRED),
        "shape": (str, OPTIONAL),
        "flutes": (int, OPTIONAL),
        "cutting_length": (NUMBER, OPTIONAL),
    },
    "cutting": {
        "feed": (NUMBER, REQUIRED),
        "plunge_feed": (NUMBER, OPTIONAL),
        "rapid_feed": (NUMBER, OPTIONAL),
        "spindle_speed": (NUMBER, REQUIRED),
    },
    "operation": {"type": (str, REQUIRED), "parameters": (dict, OPTIONAL)},
    "simulation": {
        "resolution": (NUMBER, OPTIONAL),
        "step": (NUMBER, OPTIONAL),
        "material": (NAME_OR_VALUES, OPTIONAL),
        "machine": (NAME_OR_VALUES, OPTIONAL),
        "picture": (str, OPTIONAL),
    },
    "post": {"processor": (str, OPTIONAL), "arguments": (str, OPTIONAL)},
    "output": {
        "gcode": (str, REQUIRED),
        "picture": (str, OPTIONAL),
        "document": (str, OPTIONAL),
    },
}
MAY_BE_ZERO = ("margin",)
KINDS = {
    str: "text",
    list: "a list",
    dict: "an object",
    int: "a whole number",
    NUMBER: "a number",
    NAME_OR_VALUES: "a name or an object",
}
OPERATIONS = ("adaptive", "trochoid", "lame_spiral")
# FreeCAD's own properties of an operation that a job file may set.
HOST_PARAMETERS = (
    "StartDepth",
    "FinalDepth",
    "StepDown",
    "SafeHeight",
    "ClearanceHeight",
    "CoolantMode",
    "Comment",
)
MOST_NAMES = 10  # of objects to choose from, in a sentence
PROGRESS_STEP = 0.1  # share of a job between two progress lines


def run_file(path, say=print):
    """Runs every job of a job file. say: takes one line of progress.

    Returns the report: {"jobs": [{"name", "ok", "error", "seconds", "figures", "output"}, ...],
    "failed": number}. It is also written where the file's "report" says; where that cannot be, the
    returned report has an "error" with the reason. Raises ValueError for a file that cannot be
    used at all; a job that cannot be done is in the report.
    """
    folder = os.path.dirname(os.path.abspath(path))
    try:
        with open(path, encoding="utf-8-sig") as file:  # Windows' editors begin with a mark
            content = json.load(file, object_pairs_hook=_object, parse_constant=_refuse_constant)
    except OSError as error:
        raise ValueError("The job file %s cannot be read: %s." % (path, error.strerror)) from None
    except _KeyTwice as error:
        raise ValueError(
            "The job file %s has the key '%s' twice in one object: take one of them out."
            % (path, error)
        ) from None
    except (ValueError, RecursionError) as error:
        raise ValueError("The job file %s is no JSON: %s." % (path, error)) from None
    _check_keys(content, FILE_KEYS, "The job file %s" % path)
    missing = compiled.missing()
    if missing:
        raise ValueError(missing)
    jobs = []
    taken = {_key(path): "the job file"}  # files by what they are
    if "report" in content:
        taken[_key(os.path.join(folder, content["report"]))] = "the report"
    for number, job in enumerate(content["jobs"], 1):
        label = "[%d/%d] %s" % (number, len(content["jobs"]), _name(job, number))
        line = functools.partial(_say_of, say, label)
        jobs.append(_run_job(job, number, folder, taken, line))
    result = {"jobs": jobs, "failed": sum(not job["ok"] for job in jobs)}
    if "report" in content:
        text = json.dumps(result, indent=2) + "\n"
        try:
            with _output(folder, content["report"], "The report") as path:
                _write(path, text)
        except ValueError as error:  # the jobs are done: what they came to is not lost
            result["error"] = str(error)
    return result


def _name(job, number):
    if isinstance(job, dict):
        for key in ("name", "model"):
            if isinstance(job.get(key), str):
                return os.path.splitext(os.path.basename(job[key]))[0]
    return "job %d" % number


def _say_of(say, label, text):
    say("%s: %s" % (label, text))


class _KeyTwice(ValueError):
    """A key that an object of a job file has twice."""


def _object(pairs):
    """An object of a job file."""
    result = {}
    for key, value in pairs:
        if key in result:
            raise _KeyTwice(key)
        result[key] = value
    return result


def _refuse_constant(name):
    """For what Python reads and JSON does not have."""
    raise ValueError("%s is no number" % name)


def _key(path):
    """The same for all ways to write a file's path."""
    return os.path.normcase(os.path.realpath(path))


def _run_job(job, number, folder, taken, say):
    result = {"name": _name(job, number), "ok": False, "error": None, "figures": {}, "output": {}}
    began = time.time()
    known = set(FreeCAD.listDocuments())
    try:
        _check_keys(job, JOB_KEYS, "Job %d" % number)
        for section, keys in SECTION_KEYS.items():
            if section in job:
                _check_keys(job[section], keys, "Job %d, %s" % (number, section))
        _do(job, number, folder, taken, say, result)
        result["ok"] = True
        say("done in %.1f s" % (time.time() - began))
    except Exception as error:
        result["error"] = str(error) or type(error).__name__
        if not isinstance(error, (ValueError, ImportError)):
            from evenload import host

            result["error"] = host.named(error)
        say("FAILED: " + result["error"])
    finally:
        for name in set(FreeCAD.listDocuments()) - known:
            FreeCAD.closeDocument(name)
    result["seconds"] = round(time.time() - began, 3)
    return result


def _do(job, number, folder, taken, say, result):
    from importlib import import_module

    from evenload import host

    kind, parameters = job["operation"]["type"], job["operation"].get("parameters", {})
    if kind not in OPERATIONS:
        raise ValueError(
            "Job %d: there is no operation '%s'; there is %s."
            % (number, kind, ", ".join(OPERATIONS))
        )
    if not job["output"].get("document", ".FCStd").endswith(".FCStd"):
        raise ValueError(
            "Job %d, output: the document is '%s': its name must end in .FCStd."
            % (number, job["output"]["document"])
        )
    files = {
        key: (name, "Job %d, output: the %s" % (number, key)) for key, name in job["output"].items()
    }
    if "picture" in job.get("simulation", {}):
        name = job["simulation"]["picture"]
        files["simulation_picture"] = name, "Job %d, simulation: the picture" % number
    # All before the work, which would be in vain.
    _claim(files, number, folder, job["model"], taken)
    for name, what in files.values():
        with _output(folder, name, what) as path:
            _try(path)
    operation = import_module("evenload.operations." + kind)
    say("reading " + job["model"])
    doc, model = _open(os.path.join(folder, job["model"]), job.get("object"))
    cutting, tool = job["cutting"], job["tool"]
    machine_job, controller = host.create_job(
        doc,
        [model],
        tool["diameter"],
        cutting["feed"],
        cutting["spindle_speed"],
        tool.get("flutes", 1),
    )
    if "shape" in tool:
        controller.Tool = host.create_tool(tool["shape"], {"Diameter": tool["diameter"]})
    if "cutting_length" in tool:
        controller.Tool.CuttingEdgeHeight = tool["cutting_length"]
    if "plunge_feed" in cutting:
        controller.VertFeed = "%.9g mm/min" % cutting["plunge_feed"]
    if "rapid_feed" in cutting:
        host.set_rapid_feed(controller, cutting["rapid_feed"])
    host.set_stock_margin(machine_job, job.get("stock", {}).get("margin", 0.0))
    doc.recompute()

    op = operation.Create(result["name"], parentJob=machine_job, toolController=controller)
    op.Base = _base(doc, model, machine_job.Model.Group[0], job["base"], number)
    _set_parameters(op, parameters, number)
    op.Proxy.progress = _progress(say)
    say("computing")
    doc.recompute()
    result["figures"] = report.figures(op)
    if not op.isValid():
        raise ValueError(op.Report or op.getStatusString())

    draw_simulation = None
    if "simulation" in job:
        say("simulating")
        figures, draw_simulation = _simulate(op, job["simulation"], folder, _progress(say))
        result["figures"].update(figures)
    post = job.get("post", {})
    text = host.post(
        machine_job, post.get("processor", "linuxcnc"), post.get("arguments", "--no-show-editor")
    )
    for key, write in (
        ("gcode", lambda path: _write(path, text)),
        ("picture", lambda path: report.picture(op, path)),
        ("simulation_picture", draw_simulation),
        ("document", lambda path: doc.saveCopy(path)),
    ):
        if key in files:
            name, what = files[key]
            with _output(folder, name, what) as path:
                write(path)
            result["output"][key] = path
            say("wrote " + os.path.relpath(path))


def _claim(files, number, folder, model, taken):
    """Adds a job's outputs to the files that are taken. Raises ValueError for one that would
    overwrite another, or the job's own model.
    """
    models = {_key(os.path.join(folder, model)): "its model"}
    for key, (name, what) in files.items():
        place = _key(os.path.join(folder, name))
        if os.path.exists(place) and not os.path.isfile(place):
            continue  # a device keeps nothing, and a folder is told of elsewhere
        other = taken.get(place) or models.get(place)
        if other:
            raise ValueError("%s would overwrite %s, %s: name another file." % (what, other, name))
        taken[place] = "the %s of job %d" % (key.replace("_", " "), number)


def _simulate(op, wishes, folder, progress):
    """(figures, function that draws them all into a file) of an operation's simulation."""
    from evenload import job_simulation, simulation_pictures

    options = {key: value for key, value in wishes.items() if key != "picture"}
    for key in ("material", "machine"):
        name = options.get(key)
        if isinstance(name, str) and os.path.isfile(os.path.join(folder, name)):
            options[key] = os.path.join(folder, name)
    setup = job_simulation.read(op)
    simulation = setup.simulate(progress=progress, **options)
    final = op.FinalDepth.Value + op.StockToLeaveAxial.Value
    depth = min(op.StepDown.Value, op.StartDepth.Value - final)
    last = op.Proxy.last

    def draw(path):
        simulation_pictures.sheet(
            simulation,
            path,
            setup.stock,
            setup.part,
            last.hole,
            target_deg=op.EngagementAngle.Value,
            nominal_rate=op.SideStep.Value * depth * last.data.feed,
            title=op.Label,
        )

    return report.simulated(simulation), draw


def _open(path, wanted):
    """(document, object to machine) of a FreeCAD document or a STEP, IGES or BREP file."""
    from evenload import host
    from evenload.floor import listed

    if not os.path.isfile(path):
        raise ValueError("There is no model file %s: mend the key 'model'." % path)
    extension = os.path.splitext(path)[1].lower()
    try:
        if extension == ".fcstd":
            doc = FreeCAD.openDocument(path, True)
        else:
            import Part

            shape = Part.read(path)
            doc = FreeCAD.newDocument("Batch")
            doc.addObject("Part::Feature", "Model").Shape = shape
            doc.recompute()
    except Exception as error:
        raise ValueError(
            "The model %s cannot be read (%s): save it anew as FCStd, STEP, IGES or BREP."
            % (path, host.text_of(error))
        ) from None
    solids = [o for o in doc.Objects if getattr(o, "Shape", None) and o.Shape.Solids]
    if wanted:
        found = [o for o in doc.Objects if wanted in (o.Name, o.Label)]
        if not found:
            raise ValueError(
                "There is no object '%s' in %s: it has %s."
                % (wanted, path, listed([o.Name for o in doc.Objects], most=MOST_NAMES))
            )
        return doc, found[0]
    tops = [o for o in solids if not any(parent in solids for parent in o.InList)]
    if len(tops) != 1:
        names = listed([o.Name for o in tops], most=MOST_NAMES)
        raise ValueError(
            "The model %s has %d solid objects: name one with the key 'object'%s."
            % (path, len(tops), ", of " + names if tops else "")
        )
    return doc, tops[0]


def _base(doc, model, in_job, names, number):
    """Base geometry from names: 'Face7' of the model, 'Sketch' or 'Body.Face7' of the document."""
    base = []
    for name in names:
        if not isinstance(name, str):
            raise ValueError("Job %d, base: %r is no name." % (number, name))
        owner, _, element = name.rpartition(".")
        if not owner and not _has(in_job, element):
            owner, element = element, ""
        if not owner:
            base.append((in_job, element))
            continue
        found = [o for o in doc.Objects if owner in (o.Name, o.Label)]
        if not found or (element and not _has(found[0], element)):
            raise ValueError(
                "Job %d, base: there is no '%s': name faces or edges of %s, as 'Face1', or "
                "sketches." % (number, name, model.Name)
            )
        base.append((in_job if found[0] is model and element else found[0], element))
    return base


def _has(obj, element):
    try:
        return bool(obj.Shape.getElement(element))
    except Exception:
        return False


def _set_parameters(op, parameters, number):
    """Numbers are mm, degrees and mm/min, texts are quantities with a unit, lists are points or
    courses.
    """
    from evenload import host

    known = [s.name for s in op.Proxy.settings] + list(HOST_PARAMETERS)
    for name, value in parameters.items():
        if name not in known:
            raise ValueError(
                "Job %d, parameters: unknown key '%s'; known keys are %s."
                % (number, name, ", ".join(known))
            )
    for name, value in parameters.items():
        kind = op.getTypeIdOfProperty(name)
        if kind == "App::PropertySpeed" and isinstance(value, NUMBER):
            value = "%.12g mm/min" % value
        if any(path == name for path, _ in op.ExpressionEngine):
            op.setExpression(name, None)
        try:
            _set_parameter(op, name, kind, value)
        except Exception as error:
            choices = op.getEnumerationsOfProperty(name) or []
            remedy = "; it can be %s" % ", ".join(choices) if choices else ""
            raise ValueError(
                "Job %d, parameters: %s cannot be %r: %s%s."
                % (number, name, parameters[name], host.text_of(error), remedy)
            ) from None


def _set_parameter(op, name, kind, value):
    """Sets a property; raises where FreeCAD refuses the value, or would take another for it."""
    if kind == "App::PropertyBool" and not isinstance(value, bool):
        raise ValueError("it must be true or false")
    if kind != "App::PropertyBool" and isinstance(value, bool):
        raise ValueError("it is no yes or no")
    if kind == "App::PropertyEnumeration" and not isinstance(value, str):
        raise ValueError("it must be a choice")
    if kind == "App::PropertyVectorDistance" and isinstance(value, list):
        value = FreeCAD.Vector(*value)
    setattr(op, name, value)
    taken = getattr(op, name)
    if isinstance(value, str) and hasattr(taken, "Value"):
        value = FreeCAD.Units.Quantity(value).Value
    if isinstance(value, NUMBER):
        taken = getattr(taken, "Value", taken)
        if not math.isclose(taken, value, rel_tol=1e-6, abs_tol=1e-9):  # such as lengths below 0
            raise ValueError("FreeCAD would take %g for it" % taken)


def _progress(say):
    said = [0.0]

    def progress(share):
        if share >= said[0] + PROGRESS_STEP:
            said[0] = share
            say("%d %%" % round(100 * share))
        return True

    return progress


def _check_keys(content, keys, where):
    if not isinstance(content, dict):
        raise ValueError("%s must be an object with the keys %s." % (where, ", ".join(keys)))
    for key in content:
        if key not in keys:
            raise ValueError(
                "%s: unknown key '%s'; known keys are %s." % (where, key, ", ".join(keys))
            )
    for key, (kind, required) in keys.items():
        if key not in content:
            if required:
                raise ValueError("%s: the key '%s' is missing." % (where, key))
        elif not isinstance(content[key], kind) or isinstance(content[key], bool):
            raise ValueError("%s: '%s' must be %s." % (where, key, KINDS[kind]))
        elif isinstance(content[key], NUMBER):
            _check_size(content[key], key, where)


def _check_size(value, key, where):
    """No number in a job file outside of `parameters` makes sense below zero."""
    least = "0 or more" if key in MAY_BE_ZERO else "more than 0"
    if not math.isfinite(value) or value < 0 or (value == 0 and key not in MAY_BE_ZERO):
        raise ValueError("%s: '%s' is %g: it must be %s." % (where, key, value, least))


@contextlib.contextmanager
def _output(folder, name, what):
    """A context with the absolute path of an output file, whose folder is made.

    name: relative to the job file's folder. Raises ValueError with a sentence, of which `what` is
    the subject, where the file cannot be written.
    """
    path = os.path.abspath(os.path.join(folder, name))
    try:
        os.makedirs(os.path.dirname(path), exist_ok=True)
        yield path
    except OSError as error:
        raise ValueError(
            "%s cannot be written to %s (%s): name another file."
            % (what, path, error.strerror or error)
        ) from None


def _try(path):
    """Raises OSError where a file cannot be written; leaves what is there as it is."""
    known = os.path.exists(path)
    open(path, "ab").close()
    if not known:
        os.remove(path)


def _write(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def main(arguments):
    """Runs the job files that EVENLOAD_JOB and the arguments name; returns the exit code."""
    output = os.fdopen(os.dup(1), "w")
    if not os.environ.get("EVENLOAD_VERBOSE"):  # FreeCAD's own progress bars and tracebacks
        silence = os.open(os.devnull, os.O_WRONLY)
        sys.stdout.flush()
        os.dup2(silence, 1)
        os.dup2(silence, 2)

    def say(line):
        print(line, file=output, flush=True)

    files = [os.environ[name] for name in ("EVENLOAD_JOB",) if os.environ.get(name)] + arguments
    if not files:
        say("No job file: name it in EVENLOAD_JOB or after batch.py.")
        return 2
    code = 0
    for path in files:
        try:
            result = run_file(path, say)
        except ValueError as error:
            say(str(error))
            code = 2
            continue
        say("")
        say(report.table(result["jobs"]))
        if "error" in result:
            say(result["error"])
        code = code or int(result["failed"] > 0 or "error" in result)
    return code


if __name__ != "evenload.batch":
    _names = [os.path.basename(argument) for argument in sys.argv]
    _first = _names.index("batch.py") + 1 if "batch.py" in _names else len(_names)
    try:
        _code = main([argument for argument in sys.argv[_first:] if argument != "--"])
    except BaseException:
        import traceback

        traceback.print_exc()
        _code = 3
    sys.stdout.flush()
    os._exit(_code)  # FreeCAD would exit with 0, and take a job file for a model to open
