// SPDX-License-Identifier: MIT
#include <flint/flint.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <chrono>
#include <cmath>
#include <exception>
#include <fstream>
#include <iostream>
#include <map>
#include <span>
#include <stdexcept>
#include <system_error>
#include <thread>

#include "certificate/point_check.hpp"
#include "certificate/prabhakar_enclosure.hpp"

namespace fde::reference::certificate {
namespace {

constexpr auto usage =
    "fde_certificate: judges mittag_leffler by rigorous enclosures at 10,000 points; exit code 1 on any "
    "fault\n"
    "  --every K      judge each K-th point\n"
    "  --region NAME  only that region\n"
    "  --worst N      print that many of the worst points\n"
    "  --slowest N    print that many of the slowest points of the library\n"
    "  --digits D     digits of the second face; 0 leaves it out\n"
    "  --threads T    threads\n"
    "  --out FILE     write the certified values to that CSV file\n"
    "  --prabhakar N  that many points of derivatives and Prabhakar's function instead\n";

struct Options {
  int every = 1, worst = 10, slowest = 0, digits = 50;
  int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  int prabhakar = 0;
  std::string region{}, out{};
};

int count_of(const std::string& name, const std::string& text) {
  int count = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (problem == std::errc() && end == text.data() + text.size()) return count;
  throw std::invalid_argument(fmt::format("{} {}: must be a whole number", name, text));
}

// The words after the program's name: options, each with a value.
Options parse_options(std::span<char* const> words) {
  Options options;
  const std::map<std::string, int*> counts{
      {"--every", &options.every},   {"--worst", &options.worst},     {"--slowest", &options.slowest},
      {"--digits", &options.digits}, {"--threads", &options.threads}, {"--prabhakar", &options.prabhakar}};
  const std::map<std::string, std::string*> texts{{"--region", &options.region}, {"--out", &options.out}};
  for (std::size_t i = 0; i < words.size(); i += 2) {
    const std::string name = words[i];
    if ((!counts.contains(name) && !texts.contains(name)) || i + 1 == words.size())
      throw std::invalid_argument(fmt::format("{}: must be an option with a value\n{}", name, usage));
    if (texts.contains(name)) {
      *texts.at(name) = words[i + 1];
    } else {
      *counts.at(name) = count_of(name, words[i + 1]);
    }
  }
  if (std::min(options.every, options.threads) < 1)
    throw std::invalid_argument("--every and --threads: must be at least 1");
  return options;
}

std::vector<int> chosen_points(const Options& options) {
  const auto names = region_names();
  if (std::ranges::find(names, options.region) == names.end() && !options.region.empty()) {
    throw std::invalid_argument(
        fmt::format("--region {}: not one of {}", options.region, fmt::join(names, ", ")));
  }
  std::vector<int> chosen;
  for (int i = 0; i < point_count; i += options.every) {
    const auto region = names.at(static_cast<std::size_t>(i / points_in_a_region));
    if (options.region.empty() || options.region == region) chosen.push_back(i);
  }
  return chosen;
}

PointCheck judge_or_fault(const Point& point, int digits) {
  try {
    return check_point(point, digits);
  } catch (const std::exception& error) {
    PointCheck row;
    row.point = point;
    row.failures.emplace_back(error.what());
    return row;
  }
}

std::vector<PointCheck> check_points(const std::vector<int>& chosen, const Options& options) {
  std::vector<PointCheck> rows(chosen.size());
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < rows.size(); i = next++) {
      rows[i] = judge_or_fault(point(chosen[i]), options.digits);
    }
    flint_cleanup();  // each thread has its own tables
  };
  std::vector<std::jthread> threads;
  for (int i = 0; i < options.threads; ++i) threads.emplace_back(work);
  threads.clear();
  return rows;
}

struct Total {
  int count = 0, near_zero = 0, faulty = 0;
  double worst = 0.0, squares = 0.0, ball = 0.0, face = 0.0, digits = 0.0;

  void add(const PointCheck& row) {
    ++count;
    near_zero += row.conditioned_ulps < row.ulps ? 1 : 0;
    faulty += row.failures.empty() ? 0 : 1;
    worst = std::max(worst, row.conditioned_ulps);
    squares += row.conditioned_ulps * row.conditioned_ulps;
    ball += row.ball_seconds;
    face += row.double_seconds;
    digits += row.digits_seconds;
  }
};

void print_line(std::string_view name, const Total& total) {
  fmt::print("{:24} {:6} {:7} {:10.3f} {:9.3f} {:9} {:8.2f} {:11.2f} {:11.2f}\n", name, total.count,
             total.faulty, total.worst, std::sqrt(total.squares / total.count), total.near_zero, total.ball,
             1e6 * total.face / total.count, 1e3 * total.digits / total.count);
}

void print_regions(const std::vector<PointCheck>& rows) {
  fmt::print("{:24} {:>6} {:>7} {:>10} {:>9} {:>9} {:>8} {:>11} {:>11}\n", "region", "points", "faulty",
             "worst ulp", "rms ulp", "near zero", "ball s", "double us", "digits ms");
  for (const std::string_view name : region_names()) {
    Total total;
    for (const PointCheck& row : rows) {
      if (row.point.region == name) total.add(row);
    }
    if (total.count > 0) print_line(name, total);
  }
  Total all;
  for (const PointCheck& row : rows) all.add(row);
  print_line("all", all);
}

void print_row(const PointCheck& row) {
  fmt::print(
      "{}: E_{{{:.17g},{:.17g}}}({:.17g}{:+.17g}i)\n  certified {} {} +- {}\n  computed  {:.17g} {:.17g} +- "
      "{:.3g}: {:.3f} ulp",
      row.point.region, row.point.alpha, row.point.beta, row.point.z.real(), row.point.z.imag(), row.re,
      row.im, row.radius, row.value_in_double.real(), row.value_in_double.imag(), row.bound, row.ulps);
  if (row.conditioned_ulps < row.ulps) fmt::print(" of |E|, {:.3f} ulp of |z E'|", row.conditioned_ulps);
  fmt::print("; ball {:.1f} ms, double {:.4f} ms, digits {:.1f} ms", 1e3 * row.ball_seconds,
             1e3 * row.double_seconds, 1e3 * row.digits_seconds);
  for (const std::string& fault : row.failures) fmt::print("\n  FAULT {}", fault);
  fmt::print("\n");
}

template <class Measure>
void print_top(std::string_view title, std::vector<PointCheck> rows, int count, Measure measure) {
  std::ranges::stable_sort(rows, std::greater{}, measure);
  rows.resize(std::min(rows.size(), static_cast<std::size_t>(std::max(count, 0))));
  if (!rows.empty()) fmt::print("\n{}\n", title);
  for (const PointCheck& row : rows) print_row(row);
}

void write_table(const std::vector<PointCheck>& rows, const std::string& path) {
  std::ofstream file(path);
  file << "region,alpha,beta,re,im,value_re,value_im,radius\n";
  for (const auto& row : rows) {
    file << fmt::format("{},{:.17g},{:.17g},{:.17g},{:.17g},{},{},{}\n", row.point.region, row.point.alpha,
                        row.point.beta, row.point.z.real(), row.point.z.imag(), row.re, row.im, row.radius);
  }
  file.close();
  if (!file) throw std::runtime_error(fmt::format("--out {}: cannot be written", path));
}

// Checks derivatives, then Prabhakar's function; prints one line for each. Returns the exit code.
int run_prabhakar(int points) {
  int faulty = 0;
  fmt::print("{:24} {:>6} {:>7} {:>10} {:>16}\n", "function", "points", "faulty", "worst ulp",
             "median double us");
  for (const int kind : {0, 1}) {
    std::vector<double> times;
    double worst = 0.0;
    int wrong = 0;
    for (int i = kind; i < points; i += 2) {
      const PrabhakarCheck row = check_point(prabhakar_point(i));
      times.push_back(row.seconds);
      worst = std::max(worst, row.ulps);
      wrong += row.failures.empty() ? 0 : 1;
      const auto& [alpha, beta, gamma, z, derivative] = row.point;
      for (const auto& fault : row.failures) {
        fmt::print(
            "  FAULT {}: alpha {:.17g} beta {:.17g} gamma {:.17g} z {:.17g}{:+.17g}i derivative {}: {} ulp\n",
            fault, alpha, beta, gamma, z.real(), z.imag(), derivative, row.ulps);
      }
    }
    std::ranges::sort(times);
    fmt::print("{:24} {:6} {:7} {:10.3f} {:16.2f}\n", kind == 0 ? "derivatives" : "prabhakar", times.size(),
               wrong, worst, times.empty() ? 0.0 : 1e6 * times[times.size() / 2]);
    faulty += wrong;
  }
  return faulty == 0 ? 0 : 1;
}

int run(const Options& options) {
  const auto start = std::chrono::steady_clock::now();
  const std::vector<PointCheck> rows = check_points(chosen_points(options), options);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  print_regions(rows);
  print_top("worst points", rows, options.worst,
            [](const PointCheck& row) { return std::pair(row.failures.size(), row.conditioned_ulps); });
  print_top("slowest points", rows, options.slowest,
            [](const PointCheck& row) { return row.double_seconds + row.digits_seconds; });
  const auto faulty =
      std::ranges::count_if(rows, [](const PointCheck& row) { return !row.failures.empty(); });
  fmt::print("\n{} points, {} faulty, {:.1f} s on {} threads\n", rows.size(), faulty, seconds.count(),
             options.threads);
  if (!options.out.empty()) write_table(rows, options.out);
  return faulty == 0 ? 0 : 1;
}

}  // namespace
}  // namespace fde::reference::certificate

int main(int count, char** words) try {
  const auto options = fde::reference::certificate::parse_options({words + 1, words + count});
  if (options.prabhakar > 0) return fde::reference::certificate::run_prabhakar(options.prabhakar);
  return fde::reference::certificate::run(options);
} catch (const std::invalid_argument& error) {
  std::cerr << error.what() << '\n';
  return 2;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 3;
}
