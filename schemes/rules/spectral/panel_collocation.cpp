// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/spectral/panel_collocation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "fdebench/schemes/problem/problem.hpp"

namespace fde {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double at_once = 1e-5;   // of the time: after a switch
constexpr double located = 1e-13;  // of the time: the accuracy with which switches are located
constexpr double part = 0.5;       // of the tolerance: a margin for errors that grow or add up

// A function with a singularity at the distance of one panel length has Legendre coefficients like 5.8^-l: so
// do the x_k on the panels that grow from a start, and the integrals over distant blocks.
Eigen::Index points_for(const Tolerance& accuracy) {
  constexpr double decay = 1.763, spare = 4.0;  // log(3 + sqrt 8)
  const double error = std::clamp(std::max(accuracy.rtol, accuracy.atol), 1e-16, 1e-2);
  return static_cast<Eigen::Index>(std::ceil(-std::log(error) / decay) + spare);
}

}  // namespace

PanelCollocation::PanelCollocation(const Problem& problem, const Tolerance& accuracy, const Options& options)
    : Stepper(problem, options),
      solution_(std::make_shared<PanelSolution>(problem, points_for(accuracy))),
      solver_(problem, solution_->integrated_rows, solution_->memory.kernels(), accuracy),
      within_{[this](double t) { return solution_->at(t); }, static_cast<int>(solution_->rule.size())},
      sides_(switch_signs(problem, 0.0, run_.start())) {
  for (const double jump : breaking_points(problem)) {
    if (jump < problem.end) interval_ends_.push_back(jump);
  }
  interval_ends_.push_back(problem.end);
}

bool PanelCollocation::is_at_end() const { return open_.empty() && interval_ends_.empty(); }

StepOutcome PanelCollocation::advance() {
  for (;;) {
    if (open_.empty()) begin_segment();
    if (may_be_panel(open_.back().block)) {
      panel_ = attempt_panel(open_.back());
      if (failure_) return *failure_;
      if (panel_) break;
      if (segment_ends_) {
        end_segment_at(last_switch_time_);
        continue;
      }
    }
    open_.push_back(half_of(open_.back(), open_.back().block.older(), solution_->rule.to_older_half));
  }
  const double t = panel_->block.time(1.0);
  solution_->panels.push_back(panel_.get());
  result_ = solution_->at(t);
  return {t};
}

// Merges the panel with the blocks that it completes, and opens the newer half of the next.
void PanelCollocation::accept(double /*t*/) {
  if (run_.ended_by_event()) return;
  if (segment_ends_) return end_segment_at(last_switch_time_);
  auto solved = std::move(panel_);
  for (open_.pop_back(); !open_.empty(); open_.pop_back()) {
    OpenBlock& parent = open_.back();
    if (!parent.older) {
      parent.older = std::move(solved);
      open_.push_back(half_of(parent, parent.block.newer(), solution_->rule.to_newer_half));
      return;
    }
    solved = merged(parent.block, std::move(parent.older), std::move(solved));
  }
  solution_->trees.push_back(std::move(solved));
  end_segment_at(interval_ends_.front());
}

void PanelCollocation::finish(Trajectory& path) {
  close_open_blocks();
  path.cost.history_bytes = solution_->bytes();
  path.cost.linear_solver = solver_.linear_solver();
  if (!solution_->panels.empty())
    path.dense_output = [solution = solution_](double t) { return solution->at(t); };
}

// A segment begins after a jump or a switch.
void PanelCollocation::begin_segment() {
  const double start = next_start_, end = interval_ends_.front();
  const double first = start > 0.0 ? std::nextafter(start, infinity) : 0.0;
  const bool breaks = end < problem_.end || std::ranges::binary_search(problem_.jump_times, end);
  const double last = breaks ? std::nextafter(end, 0.0) : infinity;
  solution_->segments.push_back({start, end - start, first, last, end});
  segment_ends_ = false;
  width_ = extrapolated_length_ > 0.0 ? std::min(extrapolated_length_ / (end - start), 1.0) : 1.0;
  last_rejected_ = {0.0, 1.0, infinity};
  if (start > 0.0 && start == last_switch_time_) sides_ = switch_signs(problem_, start, result_);
  last_unknowns_ = start == 0.0 ? solver_.initial_unknowns(run_) : Vec();
  Sources before;
  for (const auto& tree : solution_->trees) before.push_back(tree.get());
  Matrix nothing = Matrix::Zero(solution_->rule.size(), solution_->integrated_rows.row_count());
  open_.push_back({{&solution_->segments.back(), 0.0, 1.0}, std::move(nothing), std::move(before)});
}

// Ends the segment at its end, behind the last panel or before the block that was attempted.
void PanelCollocation::end_segment_at(double t) {
  next_start_ = std::min(t, interval_ends_.front());
  if (!open_.empty()) {
    const TimeBlock& last = open_.back().block;
    solution_->segments.back().end = next_start_;
    solution_->segments.back().end_place = panel_ ? last.from + last.width : last.from;
  }
  close_open_blocks();
  if (next_start_ == interval_ends_.front()) interval_ends_.erase(interval_ends_.begin());
}

// Moves the last panel and the solved halves of the open blocks to the trees. The rest of these blocks will
// not be solved.
void PanelCollocation::close_open_blocks() {
  auto solved = std::move(panel_);
  if (!open_.empty()) open_.pop_back();  // the block of the panel
  for (; !open_.empty(); open_.pop_back()) {
    OpenBlock& parent = open_.back();
    if (parent.older && solved) {
      solved = merged(parent.block, std::move(parent.older), std::move(solved));
    } else if (auto& half = parent.older ? parent.older : solved) {
      solution_->trees.push_back(std::move(half));
    }
  }
  if (solved) solution_->trees.push_back(std::move(solved));
}

bool PanelCollocation::may_be_panel(const TimeBlock& block) const {
  return block.width <= width_ && block.length() <= longest_step(problem_, block.time(-1.0));
}

// A half of an open block; to_half restricts a function that is smooth on the block to it.
PanelCollocation::OpenBlock PanelCollocation::half_of(const OpenBlock& open, const TimeBlock& block,
                                                      const Matrix& to_half) {
  OpenBlock half{block, to_half * open.smooth, {}};
  for (const auto* source : open.near)
    solution_->memory.split_near_and_far(*source, block, half.smooth, half.near);
  if (open.older) solution_->memory.split_near_and_far(*open.older, block, half.smooth, half.near);
  return half;
}

void PanelCollocation::state(Archive& /*archive*/) {
  throw std::logic_error("spectral_collocation keeps no checkpoints");
}

std::unique_ptr<MemoryBlock> PanelCollocation::merged(const TimeBlock& block,
                                                      std::unique_ptr<MemoryBlock> older,
                                                      std::unique_ptr<MemoryBlock> newer) const {
  const auto& rule = solution_->rule;
  auto whole = std::make_unique<MemoryBlock>(MemoryBlock{
      .block = block,
      .coefficients = rule.from_older * older->coefficients + rule.from_newer * newer->coefficients,
      .units = solution_->memory.kernels().units(block.length())});
  whole->older = std::move(older);
  whole->newer = std::move(newer);
  return whole;
}

std::unique_ptr<MemoryBlock> PanelCollocation::attempt_panel(const OpenBlock& open) {
  const TimeBlock& block = open.block;
  const PanelSystem task = task_on(open);
  if (std::exchange(extrapolated_length_, 0.0) > 0.0)
    return panel_over_switch(block, task, extrapolated_on(task));
  PanelValues solved{guess_on(task), {}};
  if (!solver_.solve(run_, task, solved) || contains_switch(block, task, solved.rows)) {
    auto panel = step_over_switch(block, task);
    if (!panel && !failure_ && !segment_ends_) {
      solver_.measure_rhs_error(run_, task, solved.rows);
      reject_panel(block, infinity);
    }
    return panel;
  }
  const Matrix coefficients = solution_->rule.to_coefficients * solved.unknowns;
  Vec effects;
  const auto largest_error = [&] {
    const Vec allowed = solver_.error_limits(task, solved.rows);
    effects = errors_by_degree(block, task, solved, coefficients, allowed);
    return std::max(effects.tail(2).sum() / part, discontinuity_error(block, task, solved, allowed));
  };
  double error = largest_error();
  if (!(error <= 1.0)) {
    solver_.measure_rhs_error(run_, task, solved.rows);
    error = largest_error();
  }
  // The points do not resolve a mode that grows by more than this.
  if (solver_.has_growing_mode(run_, task, solved.rows, static_cast<double>(effects.size())))
    error = infinity;
  if (!(error <= 1.0) && !is_rounding_error(block, error)) {
    reject_panel(block, error);
    return nullptr;
  }
  auto panel = panel_of(block, task, solved);
  if (passes_over_switch(*panel, task, solved.rows)) {
    reject_panel(block, infinity);
    return nullptr;
  }
  set_next_width(block, needed_fraction(effects));
  accept_values(task, solved);
  return panel;
}

// The panel as a block of the history.
std::unique_ptr<MemoryBlock> PanelCollocation::panel_of(const TimeBlock& block, const PanelSystem& task,
                                                        const PanelValues& solved) {
  return std::make_unique<MemoryBlock>(MemoryBlock{
      .block = block,
      .coefficients = solution_->rule.to_coefficients * solved.unknowns,
      .units = task.units,
      .values = solved.rows,
      .slopes = block.from == 0.0 ? solver_.algebraic_slopes(run_, task, solved.rows) : Matrix()});
}

void PanelCollocation::accept_values(const PanelSystem& task, const PanelValues& solved) {
  const Eigen::Index last = solution_->rule.size() - 1;
  solver_.accept_panel(solved);
  last_unknowns_ = solved.unknowns.bottomRows<1>().transpose();
  sides_ = switch_signs(problem_, task.times[last], solver_.values_at(solved.rows, last));
}

// Whether a switch has zeros between points of a panel that is on one side of it at all points: two, or one
// behind the switch with which the segment begins. Where the run returns to a switch at once, rounding
// decides.
bool PanelCollocation::passes_over_switch(const MemoryBlock& panel, const PanelSystem& task,
                                          const Matrix& rows) {
  if (problem_.switching_functions.empty() || panel.block.length() <= at_once * task.times[0]) return false;
  const auto sides = switch_signs(problem_, task.times[0], solver_.values_at(rows, 0));
  const bool follows_switch = panel.block.from == 0.0 && panel.block.segment->start == last_switch_time_;
  if (follows_switch && sides != sides_) return true;
  const auto y = [&](double t) -> Vec {
    const auto found = std::find(task.times.begin(), task.times.end(), t);
    if (found == task.times.end()) return solution_->at(t);
    return solver_.values_at(rows, found - task.times.begin());
  };
  solution_->panels.push_back(&panel);
  const auto other =
      time_on_other_side(problem_, sides, {task.times.begin(), task.times.end()}, y, samples_left_);
  solution_->panels.pop_back();
  return other.has_value();
}

// Whether the panel is not on one side of every switch, or not on the side of the panel before. The first
// panel behind a switch, or at t = 0, has no such side: rounding decides about its start.
bool PanelCollocation::contains_switch(const TimeBlock& panel, const PanelSystem& task,
                                       const Matrix& rows) const {
  if (problem_.switching_functions.empty()) return false;
  const Eigen::Index places = rows.rows();
  const double start = panel.segment->start;
  const bool has_side = panel.from > 0.0 || (start > 0.0 && start != last_switch_time_);
  const auto begun = has_side ? sides_ : switch_signs(problem_, task.times[0], solver_.values_at(rows, 0));
  for (Eigen::Index j = 0; j < places; ++j) {
    if (switch_signs(problem_, task.times[j], solver_.values_at(rows, j)) != begun) return true;
  }
  return false;
}

// Steps over a block as short as the accuracy with which switches are located. nullptr: the block is longer,
// or ends on the same side, or the run returns at once to the switch with which its segment begins: rounding
// may decide there on which side it is, so the segment begins again, farther behind the switch. If the run
// returns every time, or repeatedly almost at once, the solution slides along the switch and does not exist
// beyond: the run ends.
std::unique_ptr<MemoryBlock> PanelCollocation::step_over_switch(const TimeBlock& block,
                                                                const PanelSystem& task) {
  constexpr int most_returns = 32, most_restarts = 4;
  const double t = block.time(1.0), last = last_switch_time_;
  if (problem_.switching_functions.empty() || block.length() > located * t) return nullptr;
  const PanelValues followed = extrapolated_on(task);
  if (switch_signs(problem_, t, solver_.values_at(followed.rows, followed.rows.rows() - 1)) == sides_)
    return nullptr;
  const bool returns = t - last <= at_once * t, at_start = t - last <= located * t;
  returns_to_switch_ = returns ? returns_to_switch_ + 1 : 0;
  restarts_ = returns ? restarts_ + (at_start ? 1 : 0) : 0;
  if (returns_to_switch_ > most_returns || restarts_ > most_restarts) {
    failure_ = {t, SolveStatus::sliding};
    return nullptr;
  }
  if (!at_start) return panel_over_switch(block, task, followed);
  extrapolated_length_ = std::ldexp(located * t, 2 * restarts_ - 2);
  segment_ends_ = true;
  return nullptr;
}

// The x_k extrapolated over a block.
PanelValues PanelCollocation::extrapolated_on(const PanelSystem& task) {
  PanelValues followed{guess_on(task), {}};
  solver_.integrate(task, followed);
  return followed;
}

// Accepts a panel behind which a new segment begins.
std::unique_ptr<MemoryBlock> PanelCollocation::panel_over_switch(const TimeBlock& block,
                                                                 const PanelSystem& task,
                                                                 const PanelValues& followed) {
  auto panel = panel_of(block, task, followed);
  accept_values(task, followed);
  last_switch_time_ = block.time(1.0);
  segment_ends_ = true;
  return panel;
}

PanelSystem PanelCollocation::task_on(const OpenBlock& open) {
  const TimeBlock& panel = open.block;
  PanelSystem task{.times = solution_->rule.points.unaryExpr([&](double place) {
                     return std::clamp(panel.time(place), panel.segment->first, panel.segment->last);
                   }),
                   .units = solution_->memory.kernels().units(panel.length()),
                   .known = open.smooth,
                   .term_sizes = {}};
  for (const auto* source : open.near) solution_->memory.add(*source, panel, task.known);
  Matrix starts(task.known.rows(), task.known.cols());
  for (Eigen::Index j = 0; j < starts.rows(); ++j)
    starts.row(j) = solution_->integrated_rows.taylor_part(task.times[j]);
  task.term_sizes = starts.cwiseAbs().cwiseMax(task.known.cwiseAbs()).colwise().maxCoeff();
  task.known += starts;
  return task;
}

// Initial guess: the last values of the x_k; at the start of a segment, where these are not known, f at the
// memory term.
Matrix PanelCollocation::guess_on(const PanelSystem& task) {
  Matrix guess(task.known.rows(), solution_->integrated_rows.unknown_count());
  guess.rowwise() =
      (last_unknowns_.size() > 0 ? last_unknowns_ : solver_.unknowns_at_first_point(run_, task)).transpose();
  return guess;
}

// The error of the rows, in units of the tolerance, that corresponds to the Legendre coefficients of each
// degree; the largest of all rows. A coefficient of x_k counts as a constant error of x_k on the panel. Where
// f makes a row decay quickly, the row is far smaller than its x_k, and the coefficients of the row itself
// count.
Vec PanelCollocation::errors_by_degree(const TimeBlock& panel, const PanelSystem& task,
                                       const PanelValues& solved, const Matrix& of_unknowns,
                                       const Vec& allowed) {
  const auto& integrated = solution_->integrated_rows;
  Matrix effects(of_unknowns.rows(), integrated.row_count());
  for (Eigen::Index i = 0; i < allowed.size(); ++i) {
    const auto unknown = integrated.rows[static_cast<std::size_t>(i)].unknown;
    const double unit = std::max(solver_.integral_of_one(task, i), first_panel_unit(panel, i));
    effects.col(i) = unit / allowed[i] * of_unknowns.col(unknown).cwiseAbs();
  }
  const bool follows = panel.from > 0.0;  // after the initial transient
  const double in_doubt = effects.rowwise().maxCoeff().tail(2).sum();
  if (follows && in_doubt > part && !solver_.has_growing_mode(run_, task, solved.rows, 1.0)) {
    const Matrix of_rows = solution_->rule.to_coefficients * solved.rows;
    for (Eigen::Index i = 0; i < allowed.size(); ++i)
      effects.col(i) = effects.col(i).cwiseMin(of_rows.col(i).cwiseAbs() / allowed[i]);
  }
  Vec largest = effects.rowwise().maxCoeff();
  for (Eigen::Index degree = largest.size() - 2; problem_.outputs && degree < largest.size(); ++degree) {
    const Vec errors = Vec::NullaryExpr(allowed.size(), [&](Eigen::Index i) {
      const auto unknown = integrated.rows[static_cast<std::size_t>(i)].unknown;
      return std::copysign(effects(degree, i) * allowed[i], of_unknowns(degree, unknown));
    });
    largest[degree] = std::max(largest[degree], solver_.error_of_outputs(task, solved.rows, errors));
  }
  return largest;
}

// On the first panel, where x_k behaves like a power t^p, its coefficients of degree n fall like 1/n^(2p+1):
// the error of x_k, which an algebraic row has unchanged, is n times the last. In a row of an order above 1
// it acts as an error of the velocity, whose effect on the row is larger at the end than on the panel; the
// mean of the error is smaller than the last coefficients, by a factor of the number of points.
double PanelCollocation::first_panel_unit(const TimeBlock& panel, Eigen::Index row) const {
  if (panel.from > 0.0) return 0.0;
  const double order = solution_->integrated_rows.rows[static_cast<std::size_t>(row)].order;
  const auto points = static_cast<double>(solution_->rule.size());
  if (order == 0.0) return points;
  if (order <= 1.0) return 0.0;
  const double until_end = problem_.end - panel.segment->start;
  return panel.length() * std::pow(until_end, order - 1.0) / (std::tgamma(order) * points);
}

// The error, in units of the tolerance, that a discontinuity of the x_k between the panel before and this one
// indicates: the x_k are continuous, so this panel has another root of the equations, or f jumps before the
// first point and x_k is wrong up to there. Where f makes rows decay quickly, the discontinuity of the rows
// counts. The initial values of algebraic rows are not known.
double PanelCollocation::discontinuity_error(const TimeBlock& panel, const PanelSystem& task,
                                             const PanelValues& solved, const Vec& allowed) {
  constexpr double least_share = 1e-3;
  if (last_unknowns_.size() == 0) return 0.0;
  const auto& rule = solution_->rule;
  const Vec change = (solved.unknowns.transpose() * rule.at_start - last_unknowns_).cwiseAbs();
  Vec worth = Vec::Zero(allowed.size());
  for (Eigen::Index i = 0; i < allowed.size(); ++i) {
    const auto& row = solution_->integrated_rows.rows[static_cast<std::size_t>(i)];
    if (panel.from == 0.0 && row.is_algebraic()) continue;
    const double share = row.is_algebraic()
                             ? least_share
                             : std::max(std::pow((1.0 + rule.points[0]) / 2.0, row.order), least_share);
    worth[i] = share * solver_.integral_of_one(task, i) * change[row.unknown] / allowed[i];
  }
  const double most = worth.maxCoeff();
  if (panel.from == 0.0 || most <= 1.0) return most;
  const Vec moved = (solved.rows.transpose() * rule.at_start - solver_.last_end_values()).cwiseAbs();
  const double of_rows = worth.cwiseMin((moved.array() / allowed.array()).matrix()).maxCoeff();
  return of_rows > 1.0 || solver_.has_growing_mode(run_, task, solved.rows, 1.0) ? most : of_rows;
}

// The fraction of the coefficients that are needed.
double PanelCollocation::needed_fraction(const Vec& effects) {
  Eigen::Index needed = effects.size();
  while (needed > 1 && effects[needed - 1] <= 1.0) --needed;
  return static_cast<double>(needed) / static_cast<double>(effects.size());
}

// Whether the error is due to rounding: a longer panel had about the same error. The last coefficients
// amplify rounding by up to the number of points: with constraints the x_k are derivatives of the constrained
// rows.
bool PanelCollocation::is_rounding_error(const TimeBlock& panel, double error) const {
  constexpr double hardly_less = 0.5;
  return panel.from > 0.0 && panel.from == last_rejected_.from &&
         error > hardly_less * last_rejected_.error && error <= static_cast<double>(solution_->rule.size());
}

void PanelCollocation::reject_panel(const TimeBlock& block, double error) {
  const bool first = block.from == 0.0;
  const RejectedPanel before = std::exchange(last_rejected_, {block.from, block.width, error});
  double halvings = 1.0;
  if (std::isfinite(error)) {
    const auto points = static_cast<double>(solution_->rule.size());
    const double rate = first ? error_rate_at_start(before) : points / 2.0;
    halvings = std::clamp(std::floor(std::log2(error) / rate), 1.0, first ? 16.0 : 4.0);
  }
  width_ = block.width * std::exp2(-halvings);
  const double shortest = first ? 0x1p-900 : 0x1p-48 * block.from;
  const bool too_short = width_ <= shortest;
  if (!too_short && !run_.out_of_budget()) return;
  if (first && solver_.accept_unconverged_sweeps()) {  // restarts the segment
    last_switch_time_ = block.segment->start;
    segment_ends_ = true;
    return;
  }
  const auto unsolved = std::isfinite(error) ? SolveStatus::step_too_small : SolveStatus::not_converged;
  const auto reason = solver_.left_domain() ? SolveStatus::left_domain : unsolved;
  failure_ = {block.time(1.0), too_short ? reason : SolveStatus::out_of_budget};
}

// The power of its width with which the error of a first panel falls, from the last two attempts.
double PanelCollocation::error_rate_at_start(const RejectedPanel& before) const {
  constexpr double usual = 2.0, least = 0.05, most = 4.0;
  if (!(last_rejected_.error < before.error) || !std::isfinite(before.error)) return usual;
  return std::clamp(
      std::log(before.error / last_rejected_.error) / std::log(before.width / last_rejected_.width), least,
      most);
}

// Sets the largest width of the next panel: its distance from the start of the segment while panels grow from
// there; otherwise twice the width of this one if half of the coefficients were enough.
void PanelCollocation::set_next_width(const TimeBlock& panel, double needed_fraction) {
  if (panel.width >= panel.from) {
    width_ = panel.from + panel.width;
  } else {
    width_ = needed_fraction <= 0.55 ? 2.0 * panel.width : panel.width;
  }
}

}  // namespace fde
