# freecadcmd bench/run.py: runs every bench/bench_*.py and collects its figures by name.
#
# A benchmark is a module with `figures()`, which yields (name, value, unit). Names are words joined
# by dots, from the broad to the narrow ("core.star.compute"), and stay the same over time, so that
# files of different days compare. It may have a `table(values)`, which yields lines from {name:
# value}; they are printed at the end.
# EVENLOAD_BENCH_JSON names a file that gets {name: {"value": ..., "unit": ...}}.
import importlib
import json
import os
import sys
import traceback
from pathlib import Path


def collect(folder, output):
    """Returns the figures of all benchmarks in `folder` by name, and those that failed.

    output: an open file that gets every figure as soon as it is there, and the tables in the end.
    """
    sys.path.insert(0, str(folder))
    figures, failed, tables = {}, [], []
    for path in sorted(folder.glob("bench_*.py")):
        try:
            module = importlib.import_module(path.stem)
            tables += [module.table] if hasattr(module, "table") else []
            for name, value, unit in module.figures():
                if name in figures:
                    raise ValueError("two figures are named %s" % name)
                figures[name] = {"value": value, "unit": unit}
                print("%-48s %12.6g %s" % (name, value, unit), file=output, flush=True)
        except Exception:
            traceback.print_exc()
            failed.append(path.stem)
    for table in tables:
        for line in table({name: figure["value"] for name, figure in figures.items()}):
            print(line, file=output, flush=True)
    return figures, failed


def main():
    output = os.fdopen(os.dup(1), "w")
    sys.stdout.flush()
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # FreeCAD's own progress bars
    figures, failed = collect(Path(__file__).resolve().parent, output)
    target = os.environ.get("EVENLOAD_BENCH_JSON")
    if target:
        Path(target).write_text(json.dumps(figures, indent=1) + "\n")
    if failed:
        print("failed: " + ", ".join(failed), file=output)
    if not figures:
        print("no figures: bench/ holds no benchmark that yields one", file=output)
    output.close()
    return 1 if failed or not figures else 0


# FreeCAD answers an uncaught exception with exit code 0, and its __name__ is not "__main__".
code = 1
try:
    code = main()
except BaseException:
    traceback.print_exc()
sys.stdout.flush()
sys.stderr.flush()
os._exit(code)
