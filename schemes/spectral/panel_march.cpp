#include "spectral/panel_march.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace fde {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double part = 0.5;  // of what is allowed: what grows, or adds up, has room

// A function with a singularity as far away as a panel is long has Legendre coefficients like 5.8^-l: on the
// panels that grow from a start, and in what is seen of blocks.
Eigen::Index points_for(const Accuracy& accuracy) {
  constexpr double decay = 1.763, spare = 4.0;  // log(3 + sqrt 8)
  const double error = std::clamp(std::max(accuracy.relative, accuracy.absolute), 1e-16, 1e-2);
  return static_cast<Eigen::Index>(std::ceil(-std::log(error) / decay) + spare);
}

}  // namespace

PanelMarch::PanelMarch(const Problem& problem, const Accuracy& accuracy, const Options& options)
    : problem_(problem),
      solution_(std::make_shared<PanelSolution>(problem, points_for(accuracy))),
      run_(problem, options),
      solver_(problem, solution_->driven, solution_->past.kernels(), accuracy) {}

Trajectory PanelMarch::solve() {
  auto& segments = solution_->segments;
  segments.push_back({0.0, problem_.end});
  for (const double jump : problem_.jumps) {
    if (jump >= problem_.end) break;
    segments.back().length = jump - segments.back().start;
    segments.push_back({jump, problem_.end - jump});
  }
  const Matrix nothing = Matrix::Zero(solution_->rule.size(), solution_->driven.row_count());
  for (const Segment& segment : segments) {
    width_ = 1.0;
    tried_ = {1.0, infinity};
    last_drives_ = &segment == &segments.front() ? solver_.first_drives(run_) : Vec();
    Sources before;
    for (const auto& tree : solution_->trees) before.push_back(tree.get());
    auto tree = visit({&segment, 0.0, 1.0}, nothing, before);
    if (tree) solution_->trees.push_back(std::move(tree));
    if (over_) break;
  }
  run_.cost().history_bytes = solution_->bytes();
  auto path = run_.finish();
  if (!solution_->panels.empty()) path.dense = [solution = solution_](double t) { return solution->at(t); };
  return path;
}

std::unique_ptr<PastBlock> PanelMarch::visit(const TimeBlock& block, const Matrix& smooth,
                                             const Sources& near) {
  if (block.width <= width_) {
    auto panel = attempt(block, smooth, near);
    if (panel || over_) return panel;
  }
  Matrix of_half = solution_->rule.older_half * smooth;
  Sources near_half;
  for (const auto* source : near) solution_->past.sort(*source, block.older(), of_half, near_half);
  auto older = visit(block.older(), of_half, near_half);
  if (over_) {
    if (older) solution_->trees.push_back(std::move(older));
    return nullptr;
  }
  of_half = solution_->rule.newer_half * smooth;
  near_half.clear();
  for (const auto* source : near) solution_->past.sort(*source, block.newer(), of_half, near_half);
  solution_->past.sort(*older, block.newer(), of_half, near_half);
  auto newer = visit(block.newer(), of_half, near_half);
  if (over_ && !newer) {
    solution_->trees.push_back(std::move(older));
    return nullptr;
  }
  return joined(block, std::move(older), std::move(newer));
}

std::unique_ptr<PastBlock> PanelMarch::joined(const TimeBlock& block, std::unique_ptr<PastBlock> older,
                                              std::unique_ptr<PastBlock> newer) const {
  const auto& rule = solution_->rule;
  auto whole = std::make_unique<PastBlock>(
      PastBlock{.block = block,
                .coefficients = rule.from_older * older->coefficients + rule.from_newer * newer->coefficients,
                .units = solution_->past.kernels().units(block.length())});
  whole->older = std::move(older);
  whole->newer = std::move(newer);
  return whole;
}

std::unique_ptr<PastBlock> PanelMarch::attempt(const TimeBlock& block, const Matrix& smooth,
                                               const Sources& near) {
  const PanelTask task = task_on(block, smooth, near);
  PanelValues solved{guess_on(task), {}};
  if (!solver_.solve(run_, task, solved)) {
    shorten(block, infinity);
    return nullptr;
  }
  Matrix coefficients = solution_->rule.to_coefficients * solved.drives;
  const Vec effects = effects_of(block, task, solved, coefficients);
  // More than the places can see grow.
  const bool outrun = solver_.grows(run_, task, solved.rows, static_cast<double>(effects.size()));
  const double doubt = outrun || breaks_off(task, solved) ? infinity : effects.tail(2).sum() / part;
  if (!(doubt <= 1.0)) {
    shorten(block, doubt);
    return nullptr;
  }
  lengthen(block, needed_share(effects));
  solver_.pass(solved.rows);
  last_drives_ = solved.drives.transpose() * solution_->rule.at_end;
  auto panel = std::make_unique<PastBlock>(PastBlock{.block = block,
                                                     .coefficients = std::move(coefficients),
                                                     .units = task.units,
                                                     .values = std::move(solved.rows)});
  accept(*panel);
  return panel;
}

PanelTask PanelMarch::task_on(const TimeBlock& panel, const Matrix& smooth, const Sources& near) {
  PanelTask task{.times = solution_->rule.places.unaryExpr([&](double place) { return panel.time(place); }),
                 .units = solution_->past.kernels().units(panel.length()),
                 .past = smooth,
                 .size = {}};
  for (const auto* source : near) solution_->past.add(*source, panel, task.past);
  Matrix starts(task.past.rows(), task.past.cols());
  for (Eigen::Index j = 0; j < starts.rows(); ++j) starts.row(j) = solution_->driven.start(task.times[j]);
  task.size = starts.cwiseAbs().cwiseMax(task.past.cwiseAbs()).colwise().maxCoeff();
  task.past += starts;
  return task;
}

// The drives as they were last; at the start of a segment, where these are not known, as the past makes them.
Matrix PanelMarch::guess_on(const PanelTask& task) {
  Matrix guess(task.past.rows(), solution_->driven.drive_count());
  guess.rowwise() = (last_drives_.size() > 0 ? last_drives_ : solver_.drives_at(run_, task)).transpose();
  return guess;
}

// What the coefficients of each degree are worth as an error of the rows, in units of what is allowed, at
// most of all rows: as an error of the drive all over the panel. Where f makes a row decay quickly it is a
// small part of its drive, and the coefficients of the row itself say what is wrong.
Vec PanelMarch::effects_of(const TimeBlock& panel, const PanelTask& task, const PanelValues& solved,
                           const Matrix& of_drives) {
  const auto& driven = solution_->driven;
  const Vec allowed = solver_.allowed(task, solved.rows);
  Matrix effects(of_drives.rows(), driven.row_count());
  for (Eigen::Index i = 0; i < allowed.size(); ++i) {
    const auto drive = driven.rows[static_cast<std::size_t>(i)].drive;
    effects.col(i) = unit_of(task, i) / allowed[i] * of_drives.col(drive).cwiseAbs();
  }
  const bool follows = panel.from > 0.0;  // and is past the transient that a start is
  const double in_doubt = effects.rowwise().maxCoeff().tail(2).sum();
  if (follows && in_doubt > part && !solver_.grows(run_, task, solved.rows, 1.0)) {
    const Matrix of_rows = solution_->rule.to_coefficients * solved.rows;
    for (Eigen::Index i = 0; i < allowed.size(); ++i)
      effects.col(i) = effects.col(i).cwiseMin(of_rows.col(i).cwiseAbs() / allowed[i]);
  }
  return effects.rowwise().maxCoeff();
}

// What a row's integral makes of a drive of 1 all over the panel, without the powers of 2.
double PanelMarch::unit_of(const PanelTask& task, Eigen::Index row) const {
  const auto order = solution_->past.kernels().order_of(row);
  if (order < 0) return 1.0;
  return task.units[order] / std::tgamma(solution_->driven.rows[static_cast<std::size_t>(row)].order + 1.0);
}

// Whether this is another root of the equations than that of the panel before, which then begins elsewhere:
// drives are continuous.
bool PanelMarch::breaks_off(const PanelTask& task, const PanelValues& solved) const {
  constexpr double clear = 1000.0, half = 0.5;
  if (last_drives_.size() == 0 || linear(problem_)) return false;
  const Vec change = (solved.drives.transpose() * solution_->rule.at_start - last_drives_).cwiseAbs();
  const Vec sizes =
      solved.drives.cwiseAbs().colwise().maxCoeff().transpose().cwiseMax(last_drives_.cwiseAbs());
  const Vec allowed = solver_.allowed(task, solved.rows);
  for (Eigen::Index i = 0; i < allowed.size(); ++i) {
    const auto drive = solution_->driven.rows[static_cast<std::size_t>(i)].drive;
    if (change[drive] > half * sizes[drive] && unit_of(task, i) * change[drive] > clear * allowed[i])
      return true;
  }
  return false;
}

// The share of the coefficients that are needed.
double PanelMarch::needed_share(const Vec& effects) {
  Eigen::Index needed = effects.size();
  while (needed > 1 && effects[needed - 1] <= 1.0) --needed;
  return static_cast<double>(needed) / static_cast<double>(effects.size());
}

void PanelMarch::shorten(const TimeBlock& block, double doubt) {
  const bool first = block.from == 0.0;
  double halvings = 1.0;
  if (std::isfinite(doubt)) {
    const auto points = static_cast<double>(solution_->rule.size());
    const double rate = first ? rate_at_start(block.width, doubt) : points / 2.0;
    halvings = std::clamp(std::floor(std::log2(doubt) / rate), 1.0, first ? 16.0 : 4.0);
  }
  width_ = block.width * std::exp2(-halvings);
  const double shortest = first ? 0x1p-900 : 0x1p-48 * block.from;
  const bool too_short = width_ <= shortest;
  over_ = too_short || run_.out_of_budget();
  if (!over_) return;
  const auto reason = solver_.left_domain() ? Ending::singular : Ending::not_converged;
  run_.fail(too_short ? reason : Ending::out_of_budget, block.time(1.0));
}

// With which power of its width the doubt of a first panel falls, by the last two of them.
double PanelMarch::rate_at_start(double width, double doubt) {
  constexpr double usual = 2.0, least = 0.05, most = 4.0;
  const auto [before, doubt_before] = std::exchange(tried_, {width, doubt});
  if (!(doubt < doubt_before) || !std::isfinite(doubt_before)) return usual;
  return std::clamp(std::log(doubt_before / doubt) / std::log(before / width), least, most);
}

// Panels that grow from the start are as long as their distance from it; others may grow where half of the
// coefficients were enough.
void PanelMarch::lengthen(const TimeBlock& panel, double needed_share) {
  if (panel.width >= panel.from) {
    width_ = panel.from + panel.width;
  } else {
    width_ = needed_share <= 0.55 ? 2.0 * panel.width : panel.width;
  }
}

void PanelMarch::accept(const PastBlock& panel) {
  solution_->panels.push_back(&panel);
  const double t = panel.block.time(1.0);
  over_ = !run_.accept(t, solution_->at(t), [&](double between) { return solution_->at(between); });
}

}  // namespace fde
