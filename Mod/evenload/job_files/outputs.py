"""The files that jobs write: none over another, and none that cannot be written."""

import contextlib
import os


def key_of(path):
    """The same for all ways to write a file's path."""
    return os.path.normcase(os.path.realpath(path))


def claim(files, number, folder, inputs, taken):
    """Adds a job's outputs to the files that are taken. Raises ValueError for one that would
    overwrite another, or what the job reads. inputs: {what it is: name}.
    """
    read = {key_of(os.path.join(folder, name)): what for what, name in inputs.items()}
    for key, (name, what) in files.items():
        place = key_of(os.path.join(folder, name))
        if os.path.exists(place) and not os.path.isfile(place):
            continue  # a device keeps nothing, and a folder is told of elsewhere
        other = taken.get(place) or read.get(place)
        if other:
            raise ValueError("%s would overwrite %s, %s: name another file." % (what, other, name))
        taken[place] = "the %s of job %d" % (key.replace("_", " "), number)


@contextlib.contextmanager
def opened(folder, name, what):
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


def attempt(path):
    """Raises OSError where a file cannot be written; leaves what is there as it is."""
    known = os.path.exists(path)
    open(path, "ab").close()
    if not known:
        os.remove(path)


def write(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
