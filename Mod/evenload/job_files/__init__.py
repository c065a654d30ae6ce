"""Job files: FreeCAD jobs without a GUI, from JSON to G-code. `evenload.batch` starts them."""
