"""Makes the pictures of docs/ from paths that the built core computes.

    python3 docs/make_pictures.py [FOLDER]

FOLDER holds the module _core: a build tree, by default build/release of this checkout, or
Mod/evenload of an installed addon. Run it with the Python that the module was built for. Needs
numpy and matplotlib, no display and no FreeCAD. The pictures of a topic are a module of their own.
"""

import ball_end_pictures
import dexel_pictures
import dynamics_pictures
import finishing_pictures
import inspection_pictures
import lame_pictures
import optimisation_pictures
import path_pictures
import rest_pictures
import stability_pictures
import surface_pictures
import trochoid_pictures
from picture_parts import built_core


def main():
    core = built_core()
    for topic in (
        path_pictures,
        dexel_pictures,
        optimisation_pictures,
        rest_pictures,
        trochoid_pictures,
        lame_pictures,
        dynamics_pictures,
        stability_pictures,
        ball_end_pictures,
        inspection_pictures,
        finishing_pictures,
        surface_pictures,
    ):
        for draw in topic.PICTURES:
            draw(core)


if __name__ == "__main__":
    main()
