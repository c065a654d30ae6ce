"""Pictures of paths and simulations. All need matplotlib, which FreeCAD may lack."""
