#include "strategy/trochoid/trochoid_notes.h"

#include <cmath>
#include <iomanip>
#include <sstream>

namespace evenload {
namespace {

// mm: nearer to zero it would be shown with a sign.
double shown(double at) { return std::abs(at) < 0.005 ? 0 : at; }

}  // namespace

std::string fallback_note(TrochoidKind kind, Vec2 place, const std::string& why) {
  std::ostringstream note;
  note << std::fixed << std::setprecision(2) << "No trochoid was repeated near (" << shown(place.x)
       << ", " << shown(place.y) << "), " << why << ": this region was cleared pass by pass";
  if (kind == TrochoidKind::kCircular) note << ", Pattern Circular was not used";
  if (kind == TrochoidKind::kCycloid) note << ", Pattern Cycloid was not used";
  note << ".";
  return note.str();
}

std::string circles_note(Vec2 place) {
  std::ostringstream note;
  note << std::fixed << std::setprecision(2) << "The slot near (" << shown(place.x) << ", "
       << shown(place.y)
       << ") is so little wider than the tool that posts would write the turns of constant "
          "engagement as lines with corners: circles are repeated there.";
  return note.str();
}

std::string unsettled_note(int passes, double residual) {
  std::ostringstream note;
  note << std::fixed << std::setprecision(4) << "After " << passes
       << " passes the trochoid's advance still differed by " << residual
       << " mm across the slot: the greatest step was taken that keeps the engagement angle.";
  return note.str();
}

}  // namespace evenload
