// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "fdebench/benchmarks/records/external_trajectory.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {

// The columns of a scene at the times of measurements, as a function of some of its parameters.
class MeasuredModel {
 public:
  // The scene ends with the measurements unless it is posed at both ends; its columns are those of `posed`.
  // Precondition: the scheme has adaptive step size.
  MeasuredModel(SceneVariant scene, const Scene& posed, std::vector<std::string> parameters,
                ExternalTrajectory measured, const Scheme& scheme);

  // The accuracy of the runs from now on: relative, and absolute by the size of the smallest of the measured
  // columns, measured or in the last run.
  void set_accuracy(double accuracy);
  // The measured columns by the scheme, one column a row of the measurements; nullopt where the scene refuses
  // these values of the parameters or has not these columns then, or the run does not come to its end: then
  // why_none() says why.
  std::optional<Rows> columns(const Vec& theta);
  // The same by the reference. Throws std::runtime_error where there is none.
  [[nodiscard]] Rows exact_columns(const Vec& theta) const;

  [[nodiscard]] SceneVariant at(const Vec& theta) const;
  [[nodiscard]] const ExternalTrajectory& measured() const { return measured_; }
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }  // of its columns
  [[nodiscard]] const Vec& sizes() const { return sizes_; }  // of the measured columns, the largest of each
  [[nodiscard]] const std::string& why_none() const { return why_none_; }
  // Of the first run that finished with the present accuracy; infinity: none has.
  [[nodiscard]] double seconds() const { return seconds_.value_or(std::numeric_limits<double>::infinity()); }
  [[nodiscard]] int solves() const { return solves_; }

 private:
  // The indices of the measured columns in a scene, which may have others with other parameters; nullopt: one
  // is missing.
  [[nodiscard]] std::optional<std::vector<Eigen::Index>> places_in(const Scene& scene) const;

  void adjust_size(const Rows& columns);

  SceneVariant scene_;
  std::vector<std::string> parameters_;
  ExternalTrajectory measured_;
  const Scheme& scheme_;
  std::vector<std::string> names_{};
  std::vector<double> times_{};       // of the measurements, each once
  std::vector<Eigen::Index> time_{};  // of each row, its index among them
  Vec sizes_;
  double accuracy_ = 0.0, size_;  // the absolute tolerance is accuracy_ * size_
  std::string why_none_{};
  int solves_ = 0;
  std::optional<double> seconds_{};
};

// The first scheme with adaptive step size that takes the problem, or that of this id. Throws Refusal naming
// `scheme`.
const Scheme& adaptive_scheme_for(const Problem& problem, const std::optional<std::string>& id);

}  // namespace fde::bench
