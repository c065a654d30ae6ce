"""Reads a job file: JSON, and nothing that JSON only seems to be."""

import json

from evenload.job_files.keys import FILE_KEYS, check_keys


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


def content_of(path):
    """What a job file holds, with all keys that it needs at its top. Raises ValueError for a file
    that cannot be used at all.
    """
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
    check_keys(content, FILE_KEYS, "The job file %s" % path)
    return content
