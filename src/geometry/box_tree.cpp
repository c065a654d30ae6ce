#include "geometry/box_tree.h"

#include <numeric>

namespace evenload {

BoxTree::BoxTree(const std::vector<Bounds>& boxes) {
  const auto n = static_cast<std::uint32_t>(boxes.size());
  if (n == 0) return;
  items_.resize(n);
  std::iota(items_.begin(), items_.end(), 0u);

  struct Job {
    std::uint32_t node, first, last;
  };
  std::vector<Job> jobs;
  nodes_.emplace_back();
  jobs.push_back({0, 0, n});
  while (!jobs.empty()) {
    const Job job = jobs.back();
    jobs.pop_back();
    Bounds box = boxes[items_[job.first]];
    for (std::uint32_t k = job.first + 1; k < job.last; ++k) box = joined(box, boxes[items_[k]]);
    nodes_[job.node].box = box;
    if (job.last - job.first <= kLeaf) {
      nodes_[job.node].first = job.first;
      nodes_[job.node].count = job.last - job.first;
      continue;
    }
    const bool by_x = box.high.x - box.low.x >= box.high.y - box.low.y;
    const auto centre = [&](std::uint32_t item) {
      const Bounds& b = boxes[item];
      return by_x ? b.low.x + b.high.x : b.low.y + b.high.y;
    };
    const std::uint32_t middle = (job.first + job.last) / 2;
    std::nth_element(items_.begin() + job.first, items_.begin() + middle, items_.begin() + job.last,
                     [&](std::uint32_t i, std::uint32_t k) {
                       const double ci = centre(i), ck = centre(k);
                       return ci != ck ? ci < ck : i < k;
                     });
    const auto child = static_cast<std::uint32_t>(nodes_.size());
    nodes_[job.node].first = child;
    nodes_.resize(nodes_.size() + 2);
    jobs.push_back({child, job.first, middle});
    jobs.push_back({child + 1, middle, job.last});
  }
  boxes_.reserve(n);
  for (const std::uint32_t item : items_) boxes_.push_back(boxes[item]);
}

}  // namespace evenload
