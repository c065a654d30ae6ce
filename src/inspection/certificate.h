// The proof that a zone cannot become narrower, by the points that touch it.
//
// Contacts press on the zone with forces, the multipliers, along their normals: all >= 0, of sum 1.
// Where these are in balance, so that the weighted gradients vanish, no small step lowers all
// contacts at once (Karush, Kuhn and Tucker). With one contact more than degrees of freedom that
// is all; with fewer the steps that they leave free must bend the zone wider (second order).
// Law: what is proved is a local optimum of the points as they are given; it is the only one where
// deviations are small beside the feature (docs/inspection.md).
#pragma once

#include <vector>

#include "inspection/exchange.h"

namespace evenload {

struct Certificate {
  std::vector<Contact> contacts;  // with multipliers > 0
  double imbalance = 0;  // largest weighted gradient that is left, along whitened directions
  double gap = 0;        // by which the contacts' weighted mean lies below the peak
  bool is_proved = false;
};

inline constexpr double kMostImbalance = 1e-9;
// By how much a contact may lie below the peak.
inline double contact_level(double peak, double rounding) { return 1e-10 * peak + 8 * rounding; }

// `peak`: the largest deviation of all points. `directions`: the whitening.
Certificate certificate(const Deviations& at, const Eigen::MatrixXd& directions,
                        const std::vector<Contact>& contacts, double peak, double rounding);

// How the contacts, weighted by their multipliers, bend along `directions`: the second derivatives
// of the peak by differences of gradients, made positive definite. Along steps that keep the
// contacts level they are changed only where they bend inwards; `damping` adds that share of the
// largest of them to all.
Eigen::MatrixXd safe_bends(const Deviations& at, const Eigen::MatrixXd& directions,
                           const std::vector<Contact>& contacts, double peak, double damping);

}  // namespace evenload
