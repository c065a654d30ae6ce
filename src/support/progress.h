// Progress and cancelling: long functions call `progress.report(share)` often and stop soon after
// it answers false.
#pragma once

#include <functional>
#include <utility>

namespace evenload {

class Progress {
 public:
  Progress() = default;  // never cancelled, tells nobody
  // `callback` gets the share done, 0 to 1, and answers whether to go on.
  explicit Progress(std::function<bool(double)> callback) : callback_(std::move(callback)) {}

  bool report(double share) {
    if (!cancelled_ && callback_ && !callback_(share)) cancelled_ = true;
    return !cancelled_;
  }
  bool cancelled() const { return cancelled_; }

 private:
  std::function<bool(double)> callback_;
  bool cancelled_ = false;
};

}  // namespace evenload
