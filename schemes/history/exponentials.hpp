#pragma once

#include "history/exponential_memory.hpp"
#include "history/filtered_memory.hpp"
#include "history/history.hpp"
#include "history/running_sum.hpp"

namespace fde {

// The past as decaying exponentials: O(1) work a step and constant memory, good to the tolerance relative to
// every weight. Components of equal order share nodes and weights; those of order 1 keep a running sum only.
// Weights w(k) = u(k) + (-1)^k v(k) are two tables, of which the second weighs (-1)^j x_j.
class ExponentialHistory final : public History {
 public:
  ExponentialHistory(const WeightTables& tables, int steps, double tolerance, int threads = 1);
  [[nodiscard]] std::unique_ptr<History> copy() const override {
    return std::make_unique<ExponentialHistory>(*this);
  }
  void push(double t, In sample) override;
  void convolve(double t, std::size_t sum, Out result) const override;
  [[nodiscard]] std::size_t bytes() const override;
  void state(Archive& archive) override;

 private:
  // The components that share something, each with a column there in the order in which they came.
  class Columns {
   public:
    // That of a component, which is taken in where it is new.
    Eigen::Index of(Eigen::Index component);
    [[nodiscard]] const std::vector<Eigen::Index>& components() const { return components_; }
    // Whether the columns are just the components, of which there are so many.
    [[nodiscard]] bool are_all(Eigen::Index size) const;

   private:
    std::vector<Eigen::Index> components_, columns_;  // columns_[component]; -1: it has none
  };
  // Components with one kernel exponent, that weigh running sums or not, or the samples with alternating
  // sign.
  struct Group {
    long double exponent;
    bool running_sums, alternates;
    std::vector<WeightTable> tables{};
    Columns columns{};
    bool all = false;  // the sample is that of the group
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
    bool all = false;  // every component is in its own column; none is listed
  };
  // The filtered samples of components with one table.
  struct Filtered {
    WeightTable table;
    Columns columns{};
    Vec sample{};
  };
  struct FilteredUse {
    Eigen::Index component;
    std::size_t filter;
    Eigen::Index column;
  };
  struct Sum {
    std::vector<Constant> constants{};
    std::vector<Use> uses{};
    std::vector<FilteredUse> filtered{};
  };
  void leave_out_lists();
  void begin(In sample);
  void add(Sum& sum, const WeightTable& table, Eigen::Index component);
  void add_exponentials(Sum& sum, const WeightTable& table, Eigen::Index component, bool alternates);
  void add_filtered(Sum& sum, const WeightTable& table, Eigen::Index component);

  Eigen::Index size_;  // of a sample
  std::vector<Group> groups_;
  std::vector<ExponentialMemory> memories_;  // one a group
  std::vector<Filtered> filters_;
  std::vector<FilteredMemory> filtered_;  // one a filter
  std::vector<Sum> sums_;
  Vec first_;          // x_0
  double sign_ = 1.0;  // (-1)^n, n the number of samples
  bool needs_totals_ = false;
  RunningSums totals_{0};  // of x_1, x_2, ..., where they are needed
};

}  // namespace fde
