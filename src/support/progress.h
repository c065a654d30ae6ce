// Progress and cancelling. Long functions call `progress.report(share)` often and stop soon after
// it answers false; where there is no such place to stop at, for it may be anywhere in the work,
// they call `progress.step()`, and whoever has something to keep catches Cancelled.
//
// Laws: only the thread that made a Progress asks the callback, so that it may draw; steps of other
// threads are stopped, too, once that one knows. What is reported never turns back through steps:
// they tell the last share again.
#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <thread>
#include <utility>

namespace evenload {

// Thrown by Progress::step(). Never leaves a function that is given a Progress from outside the
// core: these return what exists, marked as cancelled.
class Cancelled : public std::exception {
 public:
  const char* what() const noexcept override { return "Cancelled."; }
};

class Progress {
 public:
  Progress() = default;  // never cancelled, tells nobody
  // `callback` gets the share done, 0 to 1, and answers whether to go on.
  explicit Progress(std::function<bool(double)> callback) : callback_(std::move(callback)) {}

  // Condition: called by the thread that made this.
  bool report(double share) {
    share_ = share;
    if (!cancelled_ && callback_ && !callback_(share)) cancelled_ = true;
    return !cancelled_;
  }
  // Whether to go on, asked at the share last told. Condition as above.
  bool goes_on() { return report(share_); }
  // Between two reports, by any thread. To be called about every millisecond.
  void step() {
    if (std::this_thread::get_id() == owner_) goes_on();
    if (cancelled_) throw Cancelled();
  }
  bool cancelled() const { return cancelled_; }

 private:
  std::function<bool(double)> callback_;
  double share_ = 0;
  std::atomic<bool> cancelled_ = false;
  std::thread::id owner_ = std::this_thread::get_id();
};

// For a part of the work whose share of the whole is not known: may be stopped as the whole, which
// hears of no share of it.
inline Progress part_of(Progress& whole) {
  return Progress([&whole](double) { return whole.goes_on(); });
}

}  // namespace evenload
