// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/history/exponential_memory.hpp"
#include "fdebench/schemes/history/filtered_memory.hpp"
#include "fdebench/schemes/history/history.hpp"

namespace fde {

// The memory term on equal steps as a sum of exponentials: O(1) work a step and constant memory; `tolerance`
// bounds the relative error of every weight. Components of equal order share nodes and weights; components of
// order 1 need a running sum only. Weights w(k) = u(k) + (-1)^k v(k) are two tables, the second of which is
// applied to (-1)^j x_j.
class ExponentialHistory final : public History {
 public:
  ExponentialHistory(const WeightTables& tables, int steps, double tolerance);
  [[nodiscard]] std::unique_ptr<History> copy() const override {
    return std::make_unique<ExponentialHistory>(*this);
  }
  void push(double t, In sample) override;
  void convolve(double t, std::size_t sum, Out result) const override;
  [[nodiscard]] std::size_t bytes() const override;
  void state(Archive& archive) override;

 private:
  // A set of components, numbered by columns in the order in which they were added.
  class Columns {
   public:
    // The column of a component, which is added where it is new.
    Eigen::Index of(Eigen::Index component);
    [[nodiscard]] const std::vector<Eigen::Index>& components() const { return components_; }
    // Whether column i is component i for all i < size.
    [[nodiscard]] bool are_all(Eigen::Index size) const;

   private:
    std::vector<Eigen::Index> components_, columns_;  // columns_[component]; -1: not in the set
  };
  // The components of one kernel exponent whose weights apply to the samples, to their running sums, or to
  // the samples with alternating signs.
  struct Group {
    long double exponent;
    bool running_sums, alternates;
    std::vector<WeightTable> tables{};
    Columns columns{};
    bool all = false;  // the group uses the sample unchanged
    Vec sample{};
  };
  // A component whose weights are all equal: x_0 has the weight start, the others have the weight constant.
  struct Constant {
    Eigen::Index component;
    double start, constant;
  };
  // One table of a group in one sum, with the components that use it and their columns in the group; or a
  // filter, which has one table.
  struct TableUse {
    std::size_t group;
    Eigen::Index table;
    bool alternates;  // as the group
    std::vector<std::pair<Eigen::Index, Eigen::Index>> components{};
    bool all = false;  // all components, component i in column i; the list is empty
  };
  // The components with one table that has a filter.
  struct Filtered {
    WeightTable table;
    Columns columns{};
    bool all = false;  // as in Group
    Vec sample{};
  };
  struct Sum {
    std::vector<Constant> constants{};
    std::vector<TableUse> uses{};
    std::vector<TableUse> filtered{};
    bool is_one_table = false;  // the only part is one table for all components, with equal signs
  };
  void drop_identity_lists();
  void begin(In sample);
  void add(Sum& sum, const WeightTable& table, Eigen::Index component);
  void add_exponentials(Sum& sum, const WeightTable& table, Eigen::Index component, bool alternates);
  void add_filtered(Sum& sum, const WeightTable& table, Eigen::Index component);

  Eigen::Index size_;  // of a sample
  std::vector<Group> groups_;
  std::vector<ExponentialMemory> memories_;  // one a group
  std::vector<Filtered> filters_;
  std::vector<std::variant<FilteredMemory, WideFilteredMemory>> filtered_;  // one a filter
  std::vector<Sum> sums_;
  Vec first_;          // x_0
  double sign_ = 1.0;  // (-1)^n, n the number of samples
  bool needs_totals_ = false;
  RunningSums totals_{0};  // of x_1, x_2, ...; empty where not needed
};

}  // namespace fde
