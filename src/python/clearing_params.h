// The parameters that all generators share, from Python's keyword arguments.
#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "strategy/task/clearing_params.h"
#include "support/progress.h"

namespace evenload {

// Keyword arguments, taken one by one. Throws TypeError for a value of the wrong type, and for what
// is missing or not known.
class Keywords {
 public:
  // `function`: its name, for errors.
  Keywords(std::string function, const pybind11::kwargs& given)
      : function_(std::move(function)), left_(pybind11::dict(given)) {}

  template <typename T>
  void required(const char* name, T& target) {
    if (!left_.contains(name))
      throw pybind11::type_error(function_ + "() misses the argument '" + name + "'.");
    optional(name, target);
  }

  template <typename T>
  void optional(const char* name, T& target) {
    if (!left_.contains(name)) return;
    try {
      target = left_[name].template cast<T>();
    } catch (const pybind11::cast_error&) {
      throw pybind11::type_error(function_ + "()'s argument '" + name + "' has the wrong type.");
    }
    PyDict_DelItemString(left_.ptr(), name);
  }

  // One of the words of `choices`; throws std::invalid_argument for another.
  template <typename T>
  void choice(const char* name, const std::map<std::string, T>& choices, T& target) {
    if (!left_.contains(name)) return;
    std::string word;
    optional(name, word);
    const auto found = choices.find(word);
    if (found == choices.end())
      throw std::invalid_argument(unknown_choice(name, word, words_of(choices)));
    target = found->second;
  }

  // To be called at the end.
  void refuse_others() const;

 private:
  template <typename T>
  static std::vector<std::string> words_of(const std::map<std::string, T>& choices) {
    std::vector<std::string> words;
    for (const auto& [word, unused] : choices) words.push_back(word);
    return words;
  }
  static std::string unknown_choice(const std::string& name, const std::string& word,
                                    const std::vector<std::string>& known);

  std::string function_;
  pybind11::dict left_;
};

struct ClearingCall {
  ClearingParams params;
  std::function<bool(double)> progress;
};

// Takes the shared keyword arguments; those without defaults are required.
ClearingCall clearing_call(Keywords& keywords);

// Asks a Python function, which may be empty; it is called with Python's lock held, whatever the
// thread. It must outlive the result.
Progress progress_of(const std::function<bool(double)>& function);

// Their names and units, for docstrings.
extern const char* const kClearingArguments;

}  // namespace evenload
