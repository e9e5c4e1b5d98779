// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <type_traits>
#include <vector>

#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

class Archive;

// A type whose state changes from step to step and can be archived:
//   void state(Archive& archive) { archive(count_, values_, part_); }
template <class Part>
concept Archivable = requires(Part& part, Archive& archive) {
  part.state(archive);
};

// A matrix or vector that owns its entries.
template <class Part>
concept PlainMatrix = std::derived_from<Part, Eigen::PlainObjectBase<Part>>;

// Serialises the state of a run; one function state() of each part both writes and reads. A part is read into
// an object that was constructed for the same run: quantities that follow from the run are not archived, and
// sizes must agree unless `resizable` says otherwise. Numbers are stored in the binary format of this
// machine.
//
// Reading throws std::invalid_argument where the data cannot be the state of this run. It never allocates
// more numbers than are left to read.
class Archive {
 public:
  Archive& operator=(Archive&&) = delete;
  virtual ~Archive() = default;

  // Whether this archive reads (and overwrites the parts); otherwise it writes.
  [[nodiscard]] virtual bool is_reading() const = 0;

  template <class... Parts>
  void operator()(Parts&... parts) {
    (part(parts), ...);
  }

  // A number in [least, most]; throws where the number read is not.
  template <std::integral Count>
  void count(Count& value, std::type_identity_t<Count> least, std::type_identity_t<Count> most) {
    Count kept = value;
    part(kept);
    require(kept >= least && kept <= most);
    value = kept;
  }

  // `count` numbers from `first` on. Precondition: the array has this size.
  void values(double* first, Eigen::Index count) {
    transfer(first, sizeof(double) * static_cast<std::size_t>(count));
  }

  // Containers whose size may differ from the archived one; reading resizes them.
  template <class Value>
  void resizable(std::vector<Value>& values) {
    constexpr auto least = std::is_arithmetic_v<Value> ? sizeof(Value) : sizeof(double);
    const auto size = resizable_count(static_cast<Eigen::Index>(values.size()), least);
    values.resize(static_cast<std::size_t>(size));
    each(values);
  }
  void resizable(Vec& values);
  void resizable(Matrix& values);
  void resizable(SparseMatrix& values);

  // The first `count` columns of a matrix; reading adds columns where it has fewer.
  void first_columns(Matrix& matrix, Eigen::Index count);

 protected:
  // Reads or writes `count` bytes. Throws std::invalid_argument where fewer are left to read.
  virtual void transfer(void* bytes, std::size_t count) = 0;
  // The number of bytes left to read; unlimited for writing.
  [[nodiscard]] virtual std::size_t bytes_left() const = 0;

 private:
  static void require(bool holds);
  template <class Value>
  void each(std::vector<Value>& values) {
    if constexpr (std::is_arithmetic_v<Value>) {
      transfer(values.data(), sizeof(Value) * values.size());
    } else {
      for (auto& value : values) part(value);
    }
  }
  // Archives the number of entries, own when writing, each of `bytes` bytes.
  Eigen::Index resizable_count(Eigen::Index own, std::size_t bytes);
  void same_size(Eigen::Index own);

  template <class Part>
  requires(std::is_arithmetic_v<Part> && !std::same_as<Part, bool>) void part(Part& value) {
    transfer(&value, sizeof value);
  }
  void part(bool& value) {
    unsigned char kept = value ? 1 : 0;
    part(kept);
    value = kept != 0;
  }
  template <PlainMatrix Part>
  void part(Part& values) {
    same_size(values.rows());
    same_size(values.cols());
    this->values(values.data(), values.size());
  }
  template <Archivable Part>
  void part(Part& one) {
    one.state(*this);
  }
  template <class Part>
  void part(std::unique_ptr<Part>& one) {
    part(*one);
  }
  template <class Part>
  void part(std::optional<Part>& one) {
    bool is_there = one.has_value();
    part(is_there);
    if constexpr (std::default_initializable<Part>) {
      if (!is_there) return one.reset();
      if (!one) one.emplace();
    } else {  // whether it has a value depends on the run alone
      require(is_there == one.has_value());
    }
    if (one) part(*one);
  }
  template <class Part>
  void part(std::vector<Part>& parts) {
    same_size(std::ssize(parts));
    each(parts);
  }
  void part(std::vector<bool>& parts);
  template <class Part, std::size_t size>
  void part(std::array<Part, size>& parts) {
    for (auto& one : parts) part(one);
  }
};

// Archives the state of a part of a run.
using StateArchiver = std::function<void(Archive&)>;

// Passes the bytes that are written to `sink`, in order.
class WritingArchive final : public Archive {
 public:
  explicit WritingArchive(std::function<void(std::string_view bytes)> sink);
  [[nodiscard]] bool is_reading() const override { return false; }

 private:
  void transfer(void* bytes, std::size_t count) override;
  [[nodiscard]] std::size_t bytes_left() const override;

  std::function<void(std::string_view)> sink_;
};

// Reads `size` bytes in total through `source`, which fills an array with the next `count` bytes.
class ReadingArchive final : public Archive {
 public:
  ReadingArchive(std::function<void(char* bytes, std::size_t count)> source, std::size_t size);
  [[nodiscard]] bool is_reading() const override { return true; }

  // Throws std::invalid_argument where bytes are left.
  void end() const;

 private:
  void transfer(void* bytes, std::size_t count) override;
  [[nodiscard]] std::size_t bytes_left() const override { return bytes_left_; }

  std::function<void(char*, std::size_t)> source_;
  std::size_t bytes_left_;
};

}  // namespace fde
