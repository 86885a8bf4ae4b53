#pragma once

// A controller's answers in drives that began alike: most defects leave its views unchanged for
// much of a test, and many for all of it. A controller that receives the same views in the same
// order gives the same answers, so it need not be queried again.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace jaywalk {

/// Drives as a tree: each step has a view and its answer, and leads to those that came next.
class KnownDrives {
 public:
  struct Step {
    std::string view;
    double answer = 0;
  };

  KnownDrives() { forget(); }

  void forget();
  /// Goes to where all drives begin.
  void begin() { at_ = 0; }
  /// Goes on by that view and returns its answer; stays where it is if no drive went so.
  std::optional<double> follow(const std::string& view);
  /// Goes on by a step that is new. Beyond 64 MB no more is kept.
  void add(Step step);
  /// Step by step from the begin to here.
  struct Way {
    std::vector<std::string> views;
    std::vector<double> answers;
  };
  [[nodiscard]] Way way_here() const;

 private:
  /// Others are known by their index; 0 is where drives begin and stands for none.
  struct Node {
    Step step;
    std::size_t before = 0;
    std::size_t next = 0;     // the last of those that come next
    std::size_t sibling = 0;  // another one that comes next to the same
  };

  std::vector<Node> nodes_;
  std::size_t at_ = 0;
  std::size_t bytes_ = 0;
  bool full_ = false;
};

}  // namespace jaywalk
