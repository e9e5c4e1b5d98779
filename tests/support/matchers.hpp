// SPDX-License-Identifier: MIT
#pragma once

#include <gmock/gmock.h>

namespace fde::bench {

// The matchers that most tests use.
// NOLINTBEGIN(misc-unused-using-decls)
using testing::AllOf, testing::ElementsAre, testing::EndsWith, testing::HasSubstr, testing::IsEmpty,
    testing::Not, testing::StartsWith, testing::ThrowsMessage;
// NOLINTEND(misc-unused-using-decls)

}  // namespace fde::bench
