#include "surface/guides.h"

#include <algorithm>
#include <cmath>

#include "support/demand.h"
#include "surface/finish_params.h"

namespace evenload {

namespace {

constexpr double kSameShare = 1e-9;  // of a guide's length

// A line by the share of its length, 0 to 1.
class Guide {
 public:
  explicit Guide(std::vector<Vec2> corners) : corners_(std::move(corners)) {
    shares_.push_back(0);
    for (std::size_t i = 1; i < corners_.size(); ++i)
      shares_.push_back(shares_.back() + norm(corners_[i] - corners_[i - 1]));
    const double length = shares_.back();
    demand(corners_.size() > 1 && length > kSamePlace, "A guide has no length: pick another edge.");
    for (double& share : shares_) share /= length;
  }

  Vec2 at(double share) const {
    const auto after = std::upper_bound(shares_.begin() + 1, shares_.end() - 1, share);
    const auto i = static_cast<std::size_t>(after - shares_.begin());
    const double width = shares_[i] - shares_[i - 1];
    const double part = width > 0 ? (share - shares_[i - 1]) / width : 0;
    return corners_[i - 1] + part * (corners_[i] - corners_[i - 1]);
  }

  const std::vector<double>& shares() const { return shares_; }

 private:
  std::vector<Vec2> corners_;
  std::vector<double> shares_;  // of the corners
};

std::vector<double> merged(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> all(a);
  all.insert(all.end(), b.begin(), b.end());
  std::sort(all.begin(), all.end());
  all.erase(
      std::unique(all.begin(), all.end(), [](double x, double y) { return y - x < kSameShare; }),
      all.end());
  return all;
}

// Twice the area between two ways across, positive where `b` is to the left of `a`.
double area(Vec2 a0, Vec2 a1, Vec2 b1, Vec2 b0) { return cross(a1 - b0, b1 - a0); }

// Whether `c` and `d` lie on both sides of the line through `a` and `b`, or on it.
bool parts(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  return cross(b - a, c - a) * cross(b - a, d - a) <= 0;
}

// Whether two lines meet.
bool cross_each_other(const std::vector<Vec2>& one, const std::vector<Vec2>& other) {
  for (std::size_t i = 1; i < one.size(); ++i)
    for (std::size_t k = 1; k < other.size(); ++k)
      if (parts(one[i - 1], one[i], other[k - 1], other[k]) &&
          parts(other[k - 1], other[k], one[i - 1], one[i]))
        return true;
  return false;
}

// Lengthens a line at both ends.
void go_on(std::vector<Vec2>& corners, double extension) {
  const auto beyond = [&](Vec2 end, Vec2 before) {
    const double length = norm(end - before);
    return length > kSamePlace ? end + (extension / length) * (end - before) : end;
  };
  const Vec2 first = beyond(corners[0], corners[1]);
  corners.push_back(beyond(corners.back(), corners[corners.size() - 2]));
  corners.insert(corners.begin(), first);
}

}  // namespace

GuidedRows guided_rows(std::vector<Vec2> first, std::vector<Vec2> second, double stepover,
                       double extension) {
  if (!first.empty() && !second.empty()) {
    const double alike = norm(first.front() - second.front()) + norm(first.back() - second.back());
    const double turned = norm(first.front() - second.back()) + norm(first.back() - second.front());
    if (turned < alike) std::reverse(second.begin(), second.end());
  }
  const bool meet = cross_each_other(first, second);
  const Guide from(std::move(first)), to(std::move(second));
  const std::vector<double> shares = merged(from.shares(), to.shares());
  double narrowest = norm(to.at(0) - from.at(0)), widest = narrowest, least = 0, largest = 0;
  for (std::size_t i = 1; i < shares.size(); ++i) {
    const double width = norm(to.at(shares[i]) - from.at(shares[i]));
    narrowest = std::min(narrowest, width);
    widest = std::max(widest, width);
    const double between =
        area(from.at(shares[i - 1]), from.at(shares[i]), to.at(shares[i]), to.at(shares[i - 1]));
    least = std::min(least, between);
    largest = std::max(largest, between);
  }
  demand(!meet && (least == 0 || largest == 0),
         "The guides cross each other: pick two that lie side by side.");
  demand(widest < kMostPasses * stepover, "The stepover makes too many passes: raise it.");
  const double count = std::ceil(widest / stepover);
  GuidedRows result;
  result.largest_stepover = count > 1 ? widest / count : 0;
  result.least_stepover = count > 1 ? narrowest / count : 0;
  const double beyond = std::floor(extension * count / widest + 0.5 - kSameShare);
  for (double k = 0.5 - beyond; k < count + beyond; ++k) {
    std::vector<Vec2> corners;
    for (const double share : shares) {
      const Vec2 start = from.at(share);
      corners.push_back(start + (k / count) * (to.at(share) - start));
    }
    if (extension > 0) go_on(corners, extension);
    if (least < 0) std::reverse(corners.begin(), corners.end());  // the next lies to the right
    result.rows.push_back({{std::move(corners), false}});
  }
  return result;
}

}  // namespace evenload
