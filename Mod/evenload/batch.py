"""Jobs without a GUI: a job file (JSON) -> G-code, pictures and a JSON report.

    EVENLOAD_JOB=jobs.json freecadcmd Mod/evenload/batch.py
    freecadcmd Mod/evenload/batch.py jobs.json

The job file is described in docs/batch.md. Exit code 0: every job was done; 1: a job failed, the
others were done, or the report could not be written; 2: the job file could not be used.
"""

import os
import sys
import traceback

if __name__ != "evenload.batch":  # FreeCAD runs this file as a module of its own
    _folder = os.path.dirname(os.path.abspath(__file__))
    sys.path[:] = [p for p in sys.path if os.path.abspath(p) != _folder]  # our modules' short names
    if os.path.dirname(_folder) not in sys.path:
        sys.path.append(os.path.dirname(_folder))

try:
    from evenload.job_files.report import table
    from evenload.job_files.run import run_file
except BaseException:
    if __name__ == "evenload.batch":
        raise
    traceback.print_exc()
    os._exit(3)  # FreeCAD would exit with 0


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
        say(table(result["jobs"]))
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
        traceback.print_exc()
        _code = 3
    sys.stdout.flush()
    os._exit(_code)  # FreeCAD would exit with 0, and take a job file for a model to open
