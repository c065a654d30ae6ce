"""Whether an operation of a FreeCAD job is stable, and what would be: see docs/stability_chart.md.

    from evenload import job_stability
    job_stability.of(operation, "spindle.json").sentence
"""
