#include "occt/bi_arcs.h"

#include <algorithm>
#include <cmath>

namespace evenload {
namespace {

// Halvings after which chords are taken instead: 2^-16 of any curve on a machine's table is under a
// micrometre.
constexpr int kMaximumDepth = 16;
// Points of the curve that are compared with a bi-arc, at least, and in every knot span. A bi-arc's
// error has one hump on either side of the joint, so that eight points see more than nine tenths of
// it.
constexpr int kSamples = 16;
constexpr int kSamplesInSpan = 4;
// The share of the tolerance that the samples may use: what lies between them uses the rest.
constexpr double kSampledShare = 0.9;
// A quarter circle per arc keeps bi-arcs well-conditioned and free of loops.
constexpr double kMaximumTurn = kPi / 2 + 1e-9;
// Arcs with less sagitta than this, in mm, are written as lines: they differ from them by less than
// any machine's step.
constexpr double kFlatSagitta = 1e-6;
// Neighbours that leave a common line or circle by less than this, in mm, become one: rounding's
// size at 1e4 mm.
constexpr double kSameSupport = 1e-8;

Segment written(const Segment& s) {
  const bool flat = std::abs(s.bulge()) * distance(s.a, s.b) / 2 < kFlatSagitta;
  return flat ? Segment::line(s.a, s.b) : s;
}

class Fitter {
 public:
  Fitter(const std::function<PlanePoint(double)>& curve, double tolerance,
         double samples_per_parameter)
      : curve_(curve), tolerance_(tolerance), samples_per_parameter_(samples_per_parameter) {}

  void fit(double from, const PlanePoint& start, double to, const PlanePoint& end, int depth) {
    const auto pair = bi_arc(start, end, kMaximumTurn);
    if (pair && within_tolerance(*pair, from, to)) {
      append(written(pair->first));
      append(written(pair->second));
      return;
    }
    if (depth == kMaximumDepth) {
      append(Segment::line(start.p, end.p));
      return;
    }
    const double middle = 0.5 * (from + to);
    const PlanePoint halfway = curve_(middle);
    fit(from, start, middle, halfway, depth + 1);
    fit(middle, halfway, to, end, depth + 1);
  }

  Curve chain() const {
    std::vector<Vertex> vertices;
    for (const Segment& s : segments_) vertices.push_back({s.a, s.bulge()});
    if (!segments_.empty()) vertices.push_back({segments_.back().b});
    return Curve(std::move(vertices), false);
  }

 private:
  bool within_tolerance(const BiArc& pair, double from, double to) const {
    const int n =
        std::max(kSamples, static_cast<int>(std::ceil((to - from) * samples_per_parameter_)));
    for (int i = 1; i < n; ++i) {
      const Vec2 p = curve_(from + (to - from) * i / n).p;
      const double off = std::min(pair.first.distance_to(p), pair.second.distance_to(p));
      if (!(off <= kSampledShare * tolerance_)) return false;
    }
    return true;
  }

  // Lines that go on straight and arcs that go on round the same centre become one.
  void append(const Segment& s) {
    if (s.a == s.b) return;
    if (!segments_.empty()) {
      Segment& last = segments_.back();
      const bool alike = last.is_arc() == s.is_arc() && last.sweep * s.sweep >= 0;
      if (alike && std::abs(last.sweep + s.sweep) <= kPi + 1e-9) {
        const Segment joined =
            Segment::from_bulge(last.a, s.b, std::tan((last.sweep + s.sweep) / 4));
        if (joined.is_arc() == s.is_arc() && joined.distance_to(s.a) < kSameSupport &&
            std::max(joined.distance_to(last.point(0.5)), joined.distance_to(s.point(0.5))) <
                kSameSupport) {
          last = joined;
          return;
        }
      }
    }
    segments_.push_back(s);
  }

  const std::function<PlanePoint(double)>& curve_;
  double tolerance_;
  double samples_per_parameter_;
  std::vector<Segment> segments_;
};

}  // namespace

Curve bi_arcs(const std::function<PlanePoint(double)>& curve, double from, double to,
              double tolerance, int spans) {
  Fitter fitter(curve, tolerance, kSamplesInSpan * spans / (to - from));
  fitter.fit(from, curve(from), to, curve(to), 0);
  return fitter.chain();
}

}  // namespace evenload
