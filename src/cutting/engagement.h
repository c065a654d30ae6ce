// Engagement angle, side step and chip thickness of a disc of radius r [Jacsó 2021, Theses I and
// IV].
#pragma once

namespace evenload {

// Side step in mm of a straight cut at engagement `angle` rad (0 to pi) with radius mm: r (1 - cos
// theta).
double side_step(double angle, double radius);
// Its inverse, rad. Condition: 0 <= step <= 2 radius.
double engagement_angle(double step, double radius);

enum class Contour { kConcave, kConvex };
// Side step in mm that gives engagement `angle` along a contour of constant radius of curvature mm,
// seen from the material's outside [Jacsó 2021, Thesis I]. Throws std::invalid_argument where it
// does not exist: curvature < r sin theta.
double side_step_on_contour(double angle, double radius, double curvature_radius, Contour contour);

// mm, of one tooth with `feed_per_tooth` mm, over an engagement of `angle` rad that begins or ends
// at the feed's normal.
double largest_chip_thickness(double angle, double feed_per_tooth);
double mean_chip_thickness(double angle, double feed_per_tooth);

}  // namespace evenload
