// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/registry.hpp"
#include "fdebench/c/guard.hpp"
#include "fdebench/c/handles.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

using namespace fde::bench::c;

namespace {

// The ids end with a 0: they are literals, or texts of a list that lives as long as the library.
const char* scheme_id(std::size_t index) { return fde::schemes()[index].id.data(); }

}  // namespace

int fdebench_scheme_count(size_t* count) {
  return guarded([&] { given("count", count) = fde::schemes().size(); });
}

int fdebench_scheme_name(size_t index, const char** name) {
  return guarded([&] {
    auto& result = given("name", name);
    require_index("index", index, fde::schemes().size());
    result = scheme_id(index);
  });
}

int fdebench_scene_count(size_t* count) {
  return guarded([&] { given("count", count) = fde::bench::built_in_scenes().size(); });
}

int fdebench_scene_name(size_t index, const char** name) {
  return guarded([&] {
    auto& result = given("name", name);
    const auto ids = fde::bench::built_in_scenes().ids();
    require_index("index", index, ids.size());
    result = ids[index].data();
  });
}
