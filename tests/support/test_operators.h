#pragma once

#include <filesystem>

#include "app/plugins/loader.h"

/// The operators of tests/app/plugins/operators.cpp, loaded as the plugin they are.
inline stipple::Registry testOperators() {
  const auto folder = std::filesystem::path(STIPPLE_BINARY_DIR) / "tests/good_plugins";
  return std::move(stipple::loadPlugins({folder}).registry);
}
