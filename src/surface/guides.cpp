#include "surface/guides.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "support/demand.h"
#include "support/parallel.h"
#include "surface/finish_params.h"

namespace evenload {

namespace {

constexpr double kSameShare = 1e-9;  // of a guide's length

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

bool is_closed(const std::vector<Vec2>& guide) {
  return guide.size() > 3 && norm(guide.back() - guide.front()) <= kSamePlace;
}

// Positive where a closed guide goes round counter-clockwise.
double area_within(const std::vector<Vec2>& guide) {
  double sum = 0;
  for (std::size_t i = 1; i < guide.size(); ++i)
    sum += cross(guide[i - 1] - guide[0], guide[i] - guide[0]);
  return 0.5 * sum;
}

// The second of two closed guides, turned to go round the same way and to begin where it comes
// nearest to the first one's begin.
std::vector<Vec2> in_step(const std::vector<Vec2>& first, std::vector<Vec2> second) {
  if (area_within(first) * area_within(second) < 0) std::reverse(second.begin(), second.end());
  second.pop_back();
  const auto apart = [&](Vec2 corner) { return norm(corner - first.front()); };
  std::rotate(second.begin(),
              std::min_element(second.begin(), second.end(),
                               [&](Vec2 a, Vec2 b) { return apart(a) < apart(b); }),
              second.end());
  second.push_back(second.front());
  return second;
}

// The second guide, turned to run beside the first.
std::vector<Vec2> alike(const std::vector<Vec2>& first, std::vector<Vec2> second) {
  if (first.empty() || second.empty()) return second;
  if (is_closed(first) && is_closed(second)) return in_step(first, std::move(second));
  const double along = norm(first.front() - second.front()) + norm(first.back() - second.back());
  const double against = norm(first.front() - second.back()) + norm(first.back() - second.front());
  if (against < along) std::reverse(second.begin(), second.end());
  return second;
}

}  // namespace

Guides::Guide::Guide(std::vector<Vec2> corners) : corners_(std::move(corners)) {
  shares_.push_back(0);
  for (std::size_t i = 1; i < corners_.size(); ++i)
    shares_.push_back(shares_.back() + norm(corners_[i] - corners_[i - 1]));
  length_ = shares_.back();
  demand(corners_.size() > 1 && length_ > kSamePlace, "A guide has no length: pick another edge.");
  for (double& share : shares_) share /= length_;
}

Vec2 Guides::Guide::at(double share) const {
  const auto after = std::upper_bound(shares_.begin() + 1, shares_.end() - 1, share);
  const auto i = static_cast<std::size_t>(after - shares_.begin());
  const double width = shares_[i] - shares_[i - 1];
  const double part = width > 0 ? (share - shares_[i - 1]) / width : 0;
  return corners_[i - 1] + part * (corners_[i] - corners_[i - 1]);
}

Guides::Guides(std::vector<Vec2> first, std::vector<Vec2> second)
    : from_(first), to_(alike(first, second)), shares_(merged(from_.shares(), to_.shares())) {
  narrowest_ = widest_ = norm(to_.at(0) - from_.at(0));
  double least = 0, largest = 0;
  for (std::size_t i = 1; i < shares_.size(); ++i) {
    const double width = norm(to_.at(shares_[i]) - from_.at(shares_[i]));
    narrowest_ = std::min(narrowest_, width);
    widest_ = std::max(widest_, width);
    const double strip = area(from_.at(shares_[i - 1]), from_.at(shares_[i]), to_.at(shares_[i]),
                              to_.at(shares_[i - 1]));
    least = std::min(least, strip);
    largest = std::max(largest, strip);
  }
  demand(!cross_each_other(first, second) && (least == 0 || largest == 0),
         "The guides cross each other: pick two that lie side by side.");
  is_turned_ = least < 0;
}

double Guides::count_for(double stepover) const {
  demand(widest_ < kMostPasses * stepover, "The stepover makes too many passes: raise it.");
  return std::ceil(widest_ / stepover);
}

double Guides::count_for(const StepBeside& beside, int threads, Progress& progress) const {
  const std::vector<double> at = stations();
  std::vector<double> wanted(at.size(), 1.0);
  Progress asking = part_of(progress);
  parallel_for(
      at.size() - 1, thread_count(threads),
      [&](std::size_t i) {
        wanted[i] = lines_at(beside, 0.5 * (at[i] + at[i + 1]), at[i], at[i + 1]);
      },
      asking);
  const double most = *std::max_element(wanted.begin(), wanted.end());
  demand(most < kMostPasses, "The cusp height makes too many passes: raise it.");
  return std::ceil(most);
}

Vec2 Guides::between(double share, double part) const {
  const Vec2 start = from_.at(share);
  return start + part * (to_.at(share) - start);
}

std::vector<double> Guides::stations() const {
  const double longest = std::max(from_.length(), to_.length());
  std::vector<double> found{shares_.front()};
  for (std::size_t i = 1; i < shares_.size(); ++i) {
    const double width = shares_[i] - shares_[i - 1];
    const double pieces = std::max(1.0, std::ceil(width * longest / kStationsApart));
    for (double k = 1; k <= pieces; ++k) found.push_back(shares_[i - 1] + k / pieces * width);
  }
  return found;
}

// How many steps the way between the guides has to be, at a share of their lengths, of which the
// one that needs the most tells; lines run there as between the places `before` and `after`.
double Guides::lines_at(const StepBeside& beside, double share, double before, double after) const {
  const Vec2 way = to_.at(share) - from_.at(share);
  const double places = std::max(1.0, std::ceil(norm(way) / kStationsApart));
  double most = 1, guess = beside.level();
  for (double k = 0; k <= places; ++k) {
    const double part = k / places;
    const Vec2 along = between(after, part) - between(before, part);
    if (norm(along) < kSamePlace) continue;
    const double side = is_turned_ ? -1 : 1;
    const Vec2 across = side * left_normal(normalized(along));
    const std::optional<double> step = beside.from(between(share, part), across, guess);
    if (!step) continue;
    guess = *step;
    most = std::max(most, dot(way, across) / *step);
  }
  return most;
}

GuidedRows Guides::rows(double count, double extension) const {
  GuidedRows result;
  result.largest_stepover = count > 1 ? widest_ / count : 0;
  result.least_stepover = count > 1 ? narrowest_ / count : 0;
  const double beyond = std::floor(extension * count / widest_ + 0.5 - kSameShare);
  for (double k = 0.5 - beyond; k < count + beyond; ++k) {
    std::vector<Vec2> corners;
    for (const double share : shares_) corners.push_back(between(share, k / count));
    if (extension > 0) go_on(corners, extension);
    if (is_turned_) std::reverse(corners.begin(), corners.end());
    result.rows.push_back({{std::move(corners), false}});
  }
  return result;
}

}  // namespace evenload
