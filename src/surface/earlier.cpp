#include "surface/earlier.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "support/parallel.h"

namespace evenload {

namespace {

// Which segments come near to places: by points on them, in square cells.
class NearSegments {
 public:
  NearSegments(const std::vector<PlanSegment>& segments, double reach)
      : size_(1.5 * reach) {  // half of what points on a segment are apart, and the reach itself
    for (std::size_t i = 0; i < segments.size(); ++i) {
      const Vec2 way = segments[i].to - segments[i].from;
      const int count = std::max(1, static_cast<int>(std::ceil(norm(way) / reach)));
      for (int k = 0; k < count; ++k) {
        const std::int64_t key = key_of(segments[i].from + ((k + 0.5) / count) * way, 0);
        if (found_.empty() || found_.back() != std::pair(key, i)) found_.emplace_back(key, i);
      }
    }
    std::sort(found_.begin(), found_.end());
  }

  // Calls work(number) for each of them before `end`; for some more than once.
  template <typename Work>
  void each_near(Vec2 at, std::size_t end, const Work& work) const {
    for (const int column : {-1, 0, 1}) {
      // The cells of a column follow each other.
      const std::int64_t middle = key_of(at, column);
      auto i = std::lower_bound(found_.begin(), found_.end(), std::pair(middle - 1, kFirst));
      for (; i != found_.end() && i->first <= middle + 1; ++i)
        if (i->second < end) work(i->second);
    }
  }

 private:
  static constexpr std::size_t kFirst = 0;
  static constexpr double kRows = 4294967296.0;  // more than there are in a column

  std::int64_t key_of(Vec2 at, int aside) const {
    return static_cast<std::int64_t>((std::floor(at.x / size_) + aside) * kRows +
                                     std::floor(at.y / size_));
  }

  double size_;
  std::vector<std::pair<std::int64_t, std::size_t>> found_;
};

}  // namespace

std::vector<EarlierBeside> earlier_beside(const std::vector<PlanSegment>& segments,
                                          const std::vector<PlaceOnPath>& places, double reach,
                                          int threads, Progress& progress) {
  const NearSegments near(segments, reach);
  std::vector<EarlierBeside> result(places.size());
  const auto look = [&](std::size_t row) {
    const PlaceOnPath& place = places[row];
    if (!(norm(place.way) > 0)) return;
    const Vec2 along = normalized(place.way);
    near.each_near(place.at, place.segment, [&](std::size_t number) {
      const Vec2 from = segments[number].from - place.at, to = segments[number].to - place.at;
      const double start = dot(from, along), end = dot(to, along);
      if ((start <= 0) == (end <= 0)) return;
      const double beside = cross(along, from), other = cross(along, to);
      const double across = beside - start * (other - beside) / (end - start);
      if (!(std::abs(across) > kOwnPass * reach && std::abs(across) < reach)) return;
      double& nearest = across > 0 ? result[row].left : result[row].right;
      nearest = std::min(nearest, std::abs(across));
    });
  };
  parallel_for(places.size(), thread_count(threads), look, progress);
  return result;
}

}  // namespace evenload
