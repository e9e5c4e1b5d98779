#pragma once

#include "history/exponential_memory.hpp"
#include "history/history.hpp"
#include "history/running_sum.hpp"

namespace fde {

// The past as decaying exponentials: O(1) work a step and constant memory, good to the tolerance relative to
// every weight. Components of equal order share nodes and weights; those of order 1 keep a running sum only.
class ExponentialHistory final : public History {
 public:
  ExponentialHistory(const WeightTables& tables, int steps, double tolerance);
  [[nodiscard]] std::unique_ptr<History> copy() const override {
    return std::make_unique<ExponentialHistory>(*this);
  }
  void push(double t, In sample) override;
  void convolve(double t, std::size_t sum, Out result) const override;
  [[nodiscard]] std::size_t bytes() const override;

 private:
  // Components with one kernel exponent, that weigh running sums or not.
  struct Group {
    long double exponent;
    bool running_sums;
    std::vector<WeightTable> tables{};
    std::vector<Eigen::Index> components{};
    Vec sample{};
  };
  // Components whose weights are all equal: x_0 counts with start, the others with constant.
  struct Constant {
    Eigen::Index component;
    double start, constant;
  };
  // One table of a group, for the components (with their column in the group) that use it in this sum.
  struct Use {
    std::size_t group;
    Eigen::Index table;
    std::vector<std::pair<Eigen::Index, Eigen::Index>> components{};
  };
  struct Sum {
    std::vector<Constant> constants{};
    std::vector<Use> uses{};
  };
  void add(Sum& sum, const WeightTable& table, Eigen::Index component);

  std::vector<Group> groups_;
  std::vector<ExponentialMemory> memories_;  // one a group
  std::vector<Sum> sums_;
  Vec first_;  // x_0
  bool needs_totals_ = false;
  RunningSums totals_;  // of x_1, x_2, ...
};

}  // namespace fde
