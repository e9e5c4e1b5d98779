// SPDX-License-Identifier: MIT
#include "fdebench/schemes/problem/archive.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

namespace fde {
namespace {

// Whether these are valid index arrays of a compressed sparse matrix with this inner size.
bool compressed(const std::vector<int>& outer, const std::vector<int>& inner, Eigen::Index rows) {
  return outer.front() == 0 && outer.back() == std::ssize(inner) && std::ranges::is_sorted(outer) &&
         std::ranges::all_of(inner, [rows](int row) { return row >= 0 && row < rows; });
}

}  // namespace

void Archive::require(bool holds) {
  if (!holds) throw std::invalid_argument("holds no state of this run");
}

Eigen::Index Archive::resizable_count(Eigen::Index own, std::size_t bytes) {
  std::int64_t size = own;
  part(size);
  require(size >= 0 && static_cast<std::size_t>(size) <= bytes_left() / bytes);
  return size;
}

void Archive::same_size(Eigen::Index own) {
  std::int64_t size = own;
  part(size);
  require(size == own);
}

void Archive::resizable(Vec& values) {
  values.resize(resizable_count(values.size(), sizeof(double)));
  this->values(values.data(), values.size());
}

void Archive::resizable(Matrix& values) {
  std::int64_t rows = values.rows();
  part(rows);
  require(rows >= 0);
  const auto of_column = sizeof(double) * static_cast<std::size_t>(std::max<std::int64_t>(rows, 1));
  const auto columns = resizable_count(values.cols(), of_column);
  values.resize(rows, columns);
  this->values(values.data(), values.size());
}

void Archive::resizable(SparseMatrix& values) {
  same_size(values.rows());
  same_size(values.cols());
  values.makeCompressed();
  std::vector<int> outer(values.outerIndexPtr(), values.outerIndexPtr() + values.outerSize() + 1);
  std::vector<int> inner(values.innerIndexPtr(), values.innerIndexPtr() + values.nonZeros());
  part(outer);
  resizable(inner);
  require(compressed(outer, inner, values.innerSize()));
  if (is_reading()) {
    values.resizeNonZeros(std::ssize(inner));
    std::ranges::copy(outer, values.outerIndexPtr());
    std::ranges::copy(inner, values.innerIndexPtr());
  }
  this->values(values.valuePtr(), std::ssize(inner));
}

void Archive::first_columns(Matrix& matrix, Eigen::Index count) {
  same_size(matrix.rows());
  const auto of_column = sizeof(double) * static_cast<std::size_t>(std::max<Eigen::Index>(matrix.rows(), 1));
  require(count >= 0 && (!is_reading() || static_cast<std::size_t>(count) <= bytes_left() / of_column));
  if (count > matrix.cols()) matrix.conservativeResize(Eigen::NoChange, count);
  values(matrix.data(), matrix.rows() * count);
}

void Archive::part(std::vector<bool>& parts) {
  same_size(std::ssize(parts));
  for (auto&& one : parts) {
    bool value = one;
    part(value);
    one = value;
  }
}

WritingArchive::WritingArchive(std::function<void(std::string_view bytes)> sink) : sink_(std::move(sink)) {}

void WritingArchive::transfer(void* bytes, std::size_t count) { sink_({static_cast<char*>(bytes), count}); }

std::size_t WritingArchive::bytes_left() const { return std::numeric_limits<std::size_t>::max(); }

ReadingArchive::ReadingArchive(std::function<void(char* bytes, std::size_t count)> source, std::size_t size)
    : source_(std::move(source)), bytes_left_(size) {}

void ReadingArchive::transfer(void* bytes, std::size_t count) {
  if (count > bytes_left_) throw std::invalid_argument("ends too early");
  source_(static_cast<char*>(bytes), count);
  bytes_left_ -= count;
}

void ReadingArchive::end() const {
  if (bytes_left_ > 0) throw std::invalid_argument("goes on after its end");
}

}  // namespace fde
