#pragma once

#include <memory>

#include "scenes/equations/field_outputs.hpp"

namespace fde {

// D^order u = A u at the points of a field, A symmetric and sparse, u at t = 0 a product of what it is on
// each axis, without velocity.
class LinearField {
 public:
  LinearField() = default;
  LinearField(const LinearField&) = delete;
  LinearField& operator=(const LinearField&) = delete;
  virtual ~LinearField() = default;

  [[nodiscard]] virtual FieldShape shape() const = 0;
  [[nodiscard]] virtual const Vec& start() const = 0;  // on an axis
  // A, as a matrix and of a field.
  [[nodiscard]] virtual SparseMatrix matrix() const = 0;
  virtual void apply(In u, Out f) const = 0;
  [[nodiscard]] virtual Outputs outputs() const = 0;
  // Whether the solution is known in time, and the columns of that. at may be called by several threads.
  [[nodiscard]] virtual bool known() const = 0;
  [[nodiscard]] virtual ReferenceValue at(double t) const = 0;
};

// The components of a field of this order that is start(x), or start(x) start(y), at t = 0.
std::vector<Component> field_components(const FieldShape& shape, const Vec& start, double order);

// The problem of a field with all that is known about it.
Scene scene_of_field(const std::shared_ptr<const LinearField>& field, double order);

}  // namespace fde
