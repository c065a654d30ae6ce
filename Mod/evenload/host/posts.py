"""FreeCAD's post-processors, and what its errors say."""

import contextlib
import io
import os
import tempfile

from evenload.host.versions import MOVED, cam


def post_processors():
    """The names of the post-processors that this FreeCAD has."""
    return cam().preferences.allAvailablePostProcessors()


def post(job, processor, arguments):
    """The G-code of the whole job, as text.

    processor: a name such as 'linuxcnc' or 'grbl'; arguments: its command line, e.g.
    '--no-show-editor --precision 4'. Raises ValueError for a processor that does not exist or
    fails, and for arguments that it refuses.
    """
    known = post_processors()
    if processor not in known:
        raise ValueError(
            "There is no post-processor '%s': this FreeCAD has %s."
            % (processor, ", ".join(sorted(known)))
        )
    try:
        with contextlib.redirect_stderr(io.StringIO()):  # post-processors print how to use them
            if MOVED:
                texts = _post_modern(job, processor, arguments)
            else:
                texts = _post_old(job, processor, arguments)
    except SystemExit:  # what they do about arguments that they do not know
        texts = []
    except Exception as error:  # of FreeCAD's and other people's post-processors
        raise ValueError(
            "The post-processor '%s' failed (%s): choose another, or mend it."
            % (processor, named(error))
        ) from error
    if not texts or any(text is None for text in texts):
        raise ValueError(
            "The post-processor '%s' refuses the arguments '%s'." % (processor, arguments)
        )
    return "".join(texts)


def _post_modern(job, processor, arguments):
    from Path.Post.Processor import PostProcessorFactory

    before = job.PostProcessorArgs
    job.PostProcessorArgs = arguments
    try:
        sections = PostProcessorFactory.get_post_processor(job, processor).export()
    finally:
        job.PostProcessorArgs = before
    return [text for _, text in sections] if sections else []


def _post_old(job, processor, arguments):
    import FreeCADGui  # noqa: F401  PathPost needs it at import, without a GUI too
    from PathScripts.PathPost import CommandPathPost
    from PathScripts.PathPostProcessor import PostProcessor

    texts = []
    for objects in CommandPathPost().buildPostList(job):
        handle, name = tempfile.mkstemp(suffix=".ngc")
        os.close(handle)
        try:
            PostProcessor.load(processor).export(objects, name, arguments)
            with open(name) as file:
                texts.append(file.read() or None)
        finally:
            os.remove(name)
    return texts


def text_of(error):
    """What an exception says, without the dot at its end; FreeCAD's own carry a dictionary."""
    first = error.args[0] if error.args else ""
    text = first.get("sErrMsg", "") if isinstance(first, dict) else str(error)
    return " ".join(text.split()).rstrip(".")


def named(error):
    """An exception's kind and what it says."""
    return "%s: %s" % (type(error).__name__, text_of(error))
