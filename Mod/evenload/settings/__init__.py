"""The settings of operations: one row each, and all that is made from the rows. Needs no FreeCAD
but for `properties`.
"""
