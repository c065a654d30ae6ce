// What is wrong with a shape that a region was to be read from, and with which member of it.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace evenload {

enum class ShapeFault {
  kUnreadable,  // the text is no BREP text
  kEmpty,       // neither a face nor an edge in it
  kNotPlanar,   // a face that is not flat
  kTilted,      // a face or edge that is not parallel to XY
  kNotFinite,   // an edge without ends
  kOpen,        // edges that do not close to a wire
  kBranching,   // more than two edges meet at one point
  kCrossing,    // two wires cross
  kKernel,      // OpenCASCADE itself failed
};

class ShapeError : public std::invalid_argument {
 public:
  // `member` counts the direct children of the compound that was read, from 0; it is 0 for any
  // other shape.
  ShapeError(ShapeFault fault, std::size_t member, const std::string& sentence)
      : std::invalid_argument(sentence), fault_(fault), member_(member) {}
  ShapeFault fault() const { return fault_; }
  std::size_t member() const { return member_; }

 private:
  ShapeFault fault_;
  std::size_t member_;
};

}  // namespace evenload
