// The wall that a vibrating helical tool leaves: a side of the pass, wave by wave.
//
// A tooth touches the wall at the height z at the spindle angle at which it points there, so that
// the vibration in time is written along the axis. With alpha from the wall's normal, s = +1 for
// conventional milling (wall on the left) and -1 for climb (on the right), a pass leaves
//   n = s y + R cos alpha - R outwards,  X = feed's way + x + R sin phi along the feed,
// and the wall is the outermost of passes that lie a feed per tooth apart.
//   location error e(z) = largest n of a pass: > 0 too much removed, < 0 stock left
//   roughness = largest over z of e(z) less the cusp where a pass meets the next
//   waviness = largest e less least e
// Laws: a rigid tool has location error 0, waviness 0 and roughness fz^2/8R (1 + O(N fz/R)); a
// straight tool has no waviness, and neither has the depth p/N.
// Not in the model: the floor, run-out, wear; chatter (only where rho < 1 has it a meaning).
// Source: [Bachrathy, Insperger & Stepan 2009], [Bachrathy 2013, thesis 2].
#pragma once

#include <vector>

#include "dynamics/forced_motion.h"
#include "support/progress.h"

namespace evenload {

struct SurfaceFigures {
  double location_error = 0;   // m: the e(z) of largest magnitude
  double least = 0, most = 0;  // m: of e(z)
  double roughness = 0;        // m
  double waviness = 0;         // m
};

class Surface {
 public:
  // As forced_motion().
  Surface(const Milling& milling, const Receptance& receptance, double speed, double depth,
          double feed_per_tooth);

  SurfaceFigures figures() const;
  // Of e(z) alone, which is faster; roughness is 0.
  SurfaceFigures location() const;
  double location_error(double z) const;
  // The wall's outward offset at a height and a place along the feed, m.
  double offset(double z, double x) const;

 private:
  struct Crest {
    double alpha, offset;
    int tooth;
  };
  struct Place {
    double x, n, x_slope, n_slope, n_bend;
  };
  Crest crest(double z) const;
  Crest crest_of(int tooth, double angle) const;
  Place place(int tooth, double z, double alpha) const;
  double cusp(double z) const;
  double cusp_between_equal_passes(double z, const Crest& crest) const;
  double height() const;

  Milling milling_;
  double depth_, feed_;
  double wall_, side_;  // phi of the wall's normal; +1 or -1
  double reach_;        // rad from the wall's normal within which a crest lies
  ForcedMotion motion_;
  std::vector<double> samples_;  // of side * y over a period
  std::vector<double> positions_;
};

// location() for each pair of a speed in rad/s and a depth in m: (error, least, most), in a row.
std::vector<double> location_errors(const Milling& milling, const Receptance& receptance,
                                    const std::vector<double>& speeds,
                                    const std::vector<double>& depths, double feed_per_tooth,
                                    int threads, Progress& progress);

}  // namespace evenload
