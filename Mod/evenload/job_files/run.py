"""Runs the jobs of a job file."""

import functools
import json
import os
import time

import FreeCAD

from evenload import compiled, host
from evenload.job_files import outputs, read
from evenload.job_files import job as one
from evenload.job_files.keys import JOB_KEYS, SECTION_KEYS, check_keys


def run_file(path, say=print):
    """Runs every job of a job file. say: takes one line of progress.

    Returns the report: {"jobs": [{"name", "ok", "error", "seconds", "figures", "output"}, ...],
    "failed": number}. It is also written where the file's "report" says; where that cannot be, the
    returned report has an "error" with the reason. Raises ValueError for a file that cannot be
    used at all; a job that cannot be done is in the report.
    """
    folder = os.path.dirname(os.path.abspath(path))
    content = read.content_of(path)
    missing = compiled.missing()
    if missing:
        raise ValueError(missing)
    jobs = []
    taken = {outputs.key_of(path): "the job file"}  # files by what they are
    if "report" in content:
        taken[outputs.key_of(os.path.join(folder, content["report"]))] = "the report"
    for number, job in enumerate(content["jobs"], 1):
        label = "[%d/%d] %s" % (number, len(content["jobs"]), _name(job, number))
        line = functools.partial(_say_of, say, label)
        jobs.append(_run_job(job, number, folder, taken, line))
    result = {"jobs": jobs, "failed": sum(not job["ok"] for job in jobs)}
    if "report" in content:
        text = json.dumps(result, indent=2) + "\n"
        try:
            with outputs.opened(folder, content["report"], "The report") as path:
                outputs.write(path, text)
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


def _run_job(job, number, folder, taken, say):
    result = {"name": _name(job, number), "ok": False, "error": None, "figures": {}, "output": {}}
    began = time.time()
    known = set(FreeCAD.listDocuments())
    try:
        check_keys(job, JOB_KEYS, "Job %d" % number)
        for section, keys in SECTION_KEYS.items():
            if section in job:
                check_keys(job[section], keys, "Job %d, %s" % (number, section))
        one.do(job, number, folder, taken, say, result)
        result["ok"] = True
        say("done in %.1f s" % (time.time() - began))
    except Exception as error:
        result["error"] = str(error) or type(error).__name__
        if not isinstance(error, (ValueError, ImportError)):
            result["error"] = host.named(error)
        say("FAILED: " + result["error"])
    finally:
        for name in set(FreeCAD.listDocuments()) - known:
            FreeCAD.closeDocument(name)
    result["seconds"] = round(time.time() - began, 3)
    return result
