#include "occt/brep_text.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Shape.hxx>
#include <ios>
#include <sstream>

#include "occt/shape_error.h"

namespace evenload {

// OpenCASCADE's reader waits for ever for what a text cut short does not hold; a stream that throws
// at its end ends that.
TopoDS_Shape shape_from_brep(const std::string& text) {
  TopoDS_Shape shape;
  std::istringstream stream(text + "\n");
  stream.exceptions(std::ios::failbit | std::ios::badbit);
  BRep_Builder builder;
  try {
    BRepTools::Read(shape, stream, builder);
  } catch (const std::ios::failure&) {
    shape.Nullify();
  }
  if (shape.IsNull()) {
    throw ShapeError(ShapeFault::kUnreadable, 0, "The shape is no readable BREP text.");
  }
  return shape;
}

}  // namespace evenload
