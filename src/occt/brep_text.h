// A shape from the text that FreeCAD writes of it.
#pragma once

#include <string>

class TopoDS_Shape;

namespace evenload {

// Throws ShapeError for a text that is none.
TopoDS_Shape shape_from_brep(const std::string& text);

}  // namespace evenload
