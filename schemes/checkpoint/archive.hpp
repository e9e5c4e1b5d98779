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

#include "problem/vectors.hpp"

namespace fde {

class Archive;

// Says what it keeps from step to step:
//   void state(Archive& archive) { archive(count_, values_, part_); }
template <class Part>
concept HasState = requires(Part& part, Archive& archive) {
  part.state(archive);
};

// A matrix or vector that has its own entries.
template <class Part>
concept PlainMatrix = std::derived_from<Part, Eigen::PlainObjectBase<Part>>;

// The state of a run on its way out, or back in. Each part says once what it has, and what it says serves
// both ways. It is read into a part that was made for the same run: what follows from that is not kept, and
// sizes are what they are there. Numbers are kept to the bit, as this machine has them.
//
// Throws std::invalid_argument where what is read cannot be the state of this run. Nothing is allocated that
// is larger than what is left to read.
class Archive {
 public:
  Archive() = default;
  Archive(const Archive&) = delete;
  Archive& operator=(const Archive&) = delete;
  virtual ~Archive() = default;

  // Whether the parts become what is read.
  [[nodiscard]] virtual bool reads() const = 0;

  template <class... Parts>
  void operator()(Parts&... parts) {
    (part(parts), ...);
  }

  // A number from `least` to `most`.
  template <std::integral Count>
  void count(Count& value, std::type_identity_t<Count> least, std::type_identity_t<Count> most) {
    Count kept = value;
    part(kept);
    require(kept >= least && kept <= most);
    value = kept;
  }

  // So many numbers, of which there is room.
  void values(double* first, Eigen::Index count) {
    transfer(first, sizeof(double) * static_cast<std::size_t>(count));
  }

  // Of these the number may be another.
  template <class Value>
  void grown(std::vector<Value>& values) {
    const auto size = grown_count(static_cast<Eigen::Index>(values.size()), sizeof(Value));
    values.resize(static_cast<std::size_t>(size));
    each(values);
  }
  void grown(Vec& values);
  void grown(Matrix& values);
  void grown(SparseMatrix& values);

  // The first columns of a matrix, which has room for more, or is given it.
  void first_columns(Matrix& matrix, Eigen::Index count);

 protected:
  // Moves so many bytes. Throws where fewer are left to read.
  virtual void transfer(void* bytes, std::size_t count) = 0;
  // To read; what is written has no end.
  [[nodiscard]] virtual std::size_t left() const = 0;

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
  // The number of entries, each of so many bytes.
  Eigen::Index grown_count(Eigen::Index own, std::size_t bytes);
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
  template <HasState Part>
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
    } else {  // it depends on the run alone
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

// What a part of a run keeps, as a function of its own.
using State = std::function<void(Archive&)>;

// Hands what is written to `sink`, in order.
class WritingArchive final : public Archive {
 public:
  explicit WritingArchive(std::function<void(std::string_view bytes)> sink);
  [[nodiscard]] bool reads() const override { return false; }

 private:
  void transfer(void* bytes, std::size_t count) override;
  [[nodiscard]] std::size_t left() const override;

  std::function<void(std::string_view)> sink_;
};

// Takes so many bytes from `source`, in the order in which they were written.
class ReadingArchive final : public Archive {
 public:
  ReadingArchive(std::function<void(char* bytes, std::size_t count)> source, std::size_t size);
  [[nodiscard]] bool reads() const override { return true; }

  // Throws std::invalid_argument where something is left.
  void end() const;

 private:
  void transfer(void* bytes, std::size_t count) override;
  [[nodiscard]] std::size_t left() const override { return left_; }

  std::function<void(char*, std::size_t)> source_;
  std::size_t left_;
};

}  // namespace fde
