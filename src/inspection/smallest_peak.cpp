#include "inspection/smallest_peak.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "inspection/bent_step.h"
#include "inspection/whitening.h"

namespace evenload {

namespace {

constexpr int kMostSteps = 200;
constexpr std::size_t kMostTouching = 300;  // each of them may ask for a small programme
constexpr double kFirstReach = 20;          // times the peak
constexpr double kLeastReach = 1e-15;       // of the size of all
constexpr double kFirstDamping = 1e-2, kLeastDamping = 1e-9, kEasing = 0.1;
constexpr double kGoodGap = 1e-14;  // share of the peak below which steps bring nothing

double peak_of(const Rows& rows, bool is_two_sided) {
  return is_two_sided ? rows.values.cwiseAbs().maxCoeff() : rows.values.maxCoeff();
}

struct Place {
  std::unique_ptr<Deviations> at;
  Rows rows;
  double peak;
};

Place place_of(std::unique_ptr<Deviations> at) {
  Place result{std::move(at), {}, 0};
  result.rows = result.at->rows();
  result.peak = peak_of(result.rows, result.at->is_two_sided());
  return result;
}

bool has_forces(const std::vector<Contact>& contacts) {
  return std::any_of(contacts.begin(), contacts.end(),
                     [](const Contact& each) { return each.multiplier > 0; });
}

class Search {
 public:
  Search(std::unique_ptr<Deviations> start, double rounding)
      : rounding_(rounding),
        place_(place_of(std::move(start))),
        directions_(whitening(place_.rows.gradients)),
        reach_(kFirstReach * std::max(place_.peak, rounding)) {}

  Optimum run() {
    for (int i = 0; i < kMostSteps && reach_ > kLeastReach; ++i)
      if (!improve()) break;
    if (!proof_.is_proved && !contacts_.empty())
      proof_ = certificate(*place_.at, directions_, contacts_, place_.peak, rounding_);
    if (!proof_.is_proved) prove_by_all();
    return {std::move(place_.at), std::move(place_.rows.values), place_.peak, proof_};
  }

 private:
  // False where there is nothing left to improve.
  bool improve() {
    const Rows linear{place_.rows.values, directions_.transpose() * place_.rows.gradients};
    const ExchangeStep found =
        best_linear_step(linear, place_.at->is_two_sided(), reach_, 0.25 * rounding_);
    if (!found.is_solved) {
      reach_ *= 0.25;
      return true;
    }
    proof_ = certificate(*place_.at, directions_, found.contacts, place_.peak, rounding_);
    contacts_ = found.contacts;
    const double before = place_.peak, promised = before - found.level;
    if (proof_.is_proved && std::min(proof_.gap, promised) <= kGoodGap * before + rounding_)
      return false;
    const bool is_full = static_cast<Eigen::Index>(found.contacts.size()) > directions_.cols();
    Place next = moved(found.step);
    double length = found.step.cwiseAbs().maxCoeff();
    if (!is_full) {
      ExchangeStep bent = bent_step(linear, found.contacts);
      Place other = moved(bent.step);
      if (other.peak >= next.peak) correct(linear, bent, other);
      // Near the end rounding alone decides who is higher.
      const bool is_good = other.peak < before + 8 * rounding_;
      damping_ = is_good ? kEasing * damping_ : std::max(damping_ / kEasing, kFirstDamping);
      if (damping_ < kLeastDamping) damping_ = 0;
      if (other.peak <= next.peak + rounding_ && settles(other, bent.contacts)) return !is_done();
      if (other.peak < next.peak) {
        next = std::move(other);
        length = bent.step.cwiseAbs().maxCoeff();
      }
    }
    const double gain = before - next.peak;
    if (gain > 0) {
      place_ = std::move(next);
      proof_ = {};
    }
    if (gain > 0.75 * promised)
      reach_ = std::max(reach_, 4 * length);
    else if (gain < 0.25 * promised)
      reach_ = 0.25 * std::min(reach_, length);
    return gain > 0.25 * rounding_ || promised > 2 * rounding_;
  }

  Place moved(const Eigen::VectorXd& step) const {
    return place_of(place_.at->moved(directions_ * step));
  }

  // Contacts bend each in its own way, which may lift the peak though their mean falls: the step is
  // found anew with the heights that it led to (a correction of second order).
  void correct(const Rows& linear, ExchangeStep& bent, Place& other) {
    const Rows led{other.rows.values - linear.gradients.transpose() * bent.step, linear.gradients};
    bent = best_bent_step(led, place_.at->is_two_sided(), bends_, 0.25 * rounding_);
    other = moved(bent.step);
  }

  // With bends of the contacts that were last found so.
  ExchangeStep bent_step(const Rows& linear, const std::vector<Contact>& contacts) {
    // Contacts that could prove nothing have no bends to tell.
    if (bent_contacts_.empty() || !has_forces(bent_contacts_)) bent_contacts_ = contacts;
    bends_ = safe_bends(*place_.at, directions_, bent_contacts_, place_.peak, damping_);
    ExchangeStep result =
        best_bent_step(linear, place_.at->is_two_sided(), bends_, 0.25 * rounding_);
    if (result.is_solved && has_forces(result.contacts)) bent_contacts_ = result.contacts;
    return result;
  }

  // Where the contacts are in balance the peak is flat: rounding hides the last steps towards it.
  bool settles(Place& other, const std::vector<Contact>& contacts) {
    if (other.peak > place_.peak + rounding_) return false;
    const Certificate now = certificate(*place_.at, directions_, contacts, place_.peak, rounding_);
    Certificate then = certificate(*other.at, directions_, contacts, other.peak, rounding_);
    if (!then.is_proved && then.imbalance > 0.5 * now.imbalance) return false;
    place_ = std::move(other);
    proof_ = std::move(then);
    contacts_ = contacts;
    return true;
  }

  // Where more points touch than a proof needs, as on prisms and grids and where deviations
  // alternate, few of them may hold no proof that all of them do, each with a part of the force.
  void prove_by_all() {
    const double lowest = place_.peak - contact_level(place_.peak, rounding_);
    const bool is_two_sided = place_.at->is_two_sided();
    std::vector<Contact> all;
    for (Eigen::Index i = 0; i < place_.rows.values.size() && all.size() <= kMostTouching; ++i) {
      const double value = place_.rows.values[i];
      const int side = is_two_sided && value < 0 ? -1 : 1;
      if (side * value >= lowest) all.push_back({i, side, 1});
    }
    Certificate found = certificate(*place_.at, directions_, all, place_.peak, rounding_);
    if (!found.is_proved && all.size() <= kMostTouching) {
      share(all);
      found = certificate(*place_.at, directions_, all, place_.peak, rounding_);
    }
    if (found.is_proved) proof_ = std::move(found);
  }

  // Gives each contact that can press a multiplier above 0.
  void share(std::vector<Contact>& contacts) const {
    Columns slopes(directions_.cols(), static_cast<Eigen::Index>(contacts.size()));
    for (std::size_t j = 0; j < contacts.size(); ++j)
      slopes.col(static_cast<Eigen::Index>(j)) =
          contacts[j].side *
          (directions_.transpose() * place_.rows.gradients.col(contacts[j].point));
    const Eigen::VectorXd shared = shared_multipliers(slopes);
    for (std::size_t j = 0; j < contacts.size(); ++j)
      contacts[j].multiplier = shared[static_cast<Eigen::Index>(j)];
  }

  bool is_done() const {
    return proof_.is_proved && proof_.gap <= kGoodGap * place_.peak + rounding_;
  }

  double rounding_;
  Place place_;
  Eigen::MatrixXd directions_, bends_;
  double reach_;
  double damping_ = 0;  // of bent steps, a share of the largest bend
  std::vector<Contact> contacts_, bent_contacts_;
  Certificate proof_;
};

}  // namespace

Optimum smallest_peak(std::unique_ptr<Deviations> start, double rounding) {
  return Search(std::move(start), rounding).run();
}

}  // namespace evenload
