#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

/// Path of a real scan under the shared data folder.
inline std::filesystem::path testData(const std::string& relative) {
  return std::filesystem::path(STIPPLE_TEST_DATA) / relative;
}

/// Skips, saying so, only where the whole data folder is absent.
#define STIPPLE_NEEDS_TEST_DATA()                                                       \
  if (!std::filesystem::is_directory(STIPPLE_TEST_DATA)) {                              \
    GTEST_SKIP() << "the folder of real scans " << STIPPLE_TEST_DATA << " is not here"; \
  }                                                                                     \
  static_assert(true)
