"""One job of a job file: its FreeCAD job, its operation, its outputs."""

import os

from evenload import host
from evenload.job_files import inspection, model, outputs, parameters, report
from evenload.operations import adaptive, finishing, lame_spiral, trochoid
from evenload.simulation import job as job_simulation
from evenload.simulation import limits
from evenload.stability import cut
from evenload.stability import operation as stability

OPERATIONS = {
    "adaptive": adaptive,
    "trochoid": trochoid,
    "lame_spiral": lame_spiral,
    "finishing": finishing,
}
# Sections of a job file that look at engagement, which operations on surfaces have none of.
OF_ENGAGEMENT = ("simulation", "stability")
PROGRESS_STEP = 0.1  # share of a job between two progress lines


def do(job, number, folder, taken, say, result):
    """Does a job whose keys are checked, the file's number `number`; `result` gets its figures and
    outputs. folder: the job file's; taken: as for outputs.claim; say: takes a line of progress.
    Raises ValueError with a sentence for what cannot be done.
    """
    operation = _operation(job, number)
    files = _files(job, number)
    # All before the work, which would be in vain.
    inspection.check(job.get("inspection"), number)
    inputs = {"its model": job["model"], **inspection.inputs(job.get("inspection", {}))}
    outputs.claim(files, number, folder, inputs, taken)
    for name, what in files.values():
        with outputs.opened(folder, name, what) as path:
            outputs.attempt(path)
    say("reading " + job["model"])
    doc, machined = model.opened(os.path.join(folder, job["model"]), job.get("object"))
    machine_job, controller = _machine_job(job, doc, machined)
    op = operation.Create(result["name"], parentJob=machine_job, toolController=controller)
    in_job = machine_job.Model.Group[0]
    op.Base = model.base_of(doc, machined, in_job, job["base"], number)
    parameters.set_all(op, job["operation"].get("parameters", {}), number)
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
    draw_stability = None
    if "stability" in job:
        say("judging stability")
        figures, draw_stability = _judge_stability(op, job["stability"], folder)
        result["figures"].update(figures)
    post = job.get("post", {})
    posting = post.get("processor", "linuxcnc"), post.get("arguments", "--no-show-editor")
    text = host.post(machine_job, *posting)
    write_inspected = {}
    if "inspection" in job:
        say("inspecting")
        asked = {"faces": job["base"], **job["inspection"]}

        def base_of(names):
            return model.base_of(doc, machined, in_job, names, number)

        figures, write_inspected = inspection.of(asked, base_of, posting, folder)
        result["figures"].update(figures)
    for key, write in (
        ("gcode", lambda path: outputs.write(path, text)),
        ("picture", lambda path: _draw(op, path)),
        ("simulation_picture", draw_simulation),
        ("stability_picture", draw_stability),
        *write_inspected.items(),
        ("document", lambda path: doc.saveCopy(path)),
    ):
        if key in files:
            name, what = files[key]
            with outputs.opened(folder, name, what) as path:
                write(path)
            result["output"][key] = path
            say("wrote " + os.path.relpath(path))


def _operation(job, number):
    """The module of a job's kind of operation."""
    kind = job["operation"]["type"]
    if kind not in OPERATIONS:
        raise ValueError(
            "Job %d: there is no operation '%s'; there is %s."
            % (number, kind, ", ".join(OPERATIONS))
        )
    for section in OF_ENGAGEMENT:
        if kind == "finishing" and section in job:
            raise ValueError(
                "Job %d, %s: there is none of a finishing operation yet: take the key out."
                % (number, section)
            )
    return OPERATIONS[kind]


def _files(job, number):
    """{key: (name, what it is, for sentences)} of a job's outputs."""
    if not job["output"].get("document", ".FCStd").endswith(".FCStd"):
        raise ValueError(
            "Job %d, output: the document is '%s': its name must end in .FCStd."
            % (number, job["output"]["document"])
        )
    files = {
        key: (name, "Job %d, output: the %s" % (number, key)) for key, name in job["output"].items()
    }
    for section in ("simulation", "stability"):
        if "picture" in job.get(section, {}):
            name = job[section]["picture"]
            files[section + "_picture"] = name, "Job %d, %s: the picture" % (number, section)
    files.update(inspection.files(job.get("inspection", {}), number))
    return files


def _machine_job(job, doc, machined):
    """(FreeCAD's job, tool controller) with the tool, the feeds and the stock that a job names."""
    cutting, tool = job["cutting"], job["tool"]
    machine_job, controller = host.create_job(
        doc,
        [machined],
        tool["diameter"],
        cutting["feed"],
        cutting["spindle_speed"],
        tool.get("flutes", 1),
    )
    if "shape" in tool:
        controller.Tool = host.create_tool(tool["shape"], {"Diameter": tool["diameter"]})
    if "corner_radius" in tool:
        try:
            host.set_corner_radius(controller.Tool, tool["corner_radius"])
        except ValueError as error:
            raise ValueError("tool: %s" % error) from None
    if "cutting_length" in tool:
        controller.Tool.CuttingEdgeHeight = tool["cutting_length"]
    if "plunge_feed" in cutting:
        controller.VertFeed = "%.9g mm/min" % cutting["plunge_feed"]
    if "rapid_feed" in cutting:
        host.set_rapid_feed(controller, cutting["rapid_feed"])
    host.set_stock_margin(machine_job, job.get("stock", {}).get("margin", 0.0))
    doc.recompute()
    return machine_job, controller


def _draw(op, path):
    # Here, because a job without pictures needs no matplotlib.
    from evenload.pictures import finishing_picture, path_picture

    is_finishing = isinstance(op.Proxy, finishing.Finishing)
    (finishing_picture if is_finishing else path_picture).picture(op, path)


def _options(wishes, folder):
    """A section without its picture; materials and machines that are files by their whole path."""
    options = {key: value for key, value in wishes.items() if key != "picture"}
    for key in ("material", "machine"):
        name = options.get(key)
        if isinstance(name, str) and os.path.isfile(os.path.join(folder, name)):
            options[key] = os.path.join(folder, name)
    return options


def _judge_stability(op, wishes, folder):
    """(figures, function that draws the chart into a file) of an operation's stability."""
    found = stability.read(op, folder=folder, **_options(wishes, folder))
    verdict = cut.judged(found)

    def draw(path):
        # Here, because a job without pictures needs no matplotlib.
        from evenload.stability import picture

        picture.save(found, verdict, path)

    return report.stability(verdict), draw


def _simulate(op, wishes, folder, progress):
    """(figures, function that draws them all into a file) of an operation's simulation."""
    options = _options(wishes, folder)
    setup = job_simulation.read(op)
    simulation = setup.simulate(progress=progress, **options)
    last = op.Proxy.last

    def draw(path):
        # Here, because a job without pictures needs no matplotlib.
        from evenload.pictures import simulation_pictures

        simulation_pictures.sheet(
            simulation,
            path,
            setup.stock,
            setup.part,
            last.hole,
            target_deg=op.EngagementAngle.Value,
            nominal_rate=limits.nominal_rate(op, last.data.feed),
            title=op.Label,
        )

    return report.simulated(simulation), draw


def _progress(say):
    said = [0.0]

    def progress(share):
        if share >= said[0] + PROGRESS_STEP:
            said[0] = share
            say("%d %%" % round(100 * share))
        return True

    return progress
