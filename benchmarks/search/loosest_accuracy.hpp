#pragma once

#include <functional>
#include <optional>

#include "search/attempt.hpp"

namespace fde {

// The attempt with the loosest accuracy asked, to a factor of two, that is within the accuracy wanted, of a
// scheme that delivers about what it is asked for. The first asks for what is wanted; then ten times more, or
// less down to a millionth, until the answer changes. nullopt: none is within.
std::optional<Attempt> loosest_accuracy(double wanted, const std::function<Attempt(double asked)>& attempt);

}  // namespace fde
