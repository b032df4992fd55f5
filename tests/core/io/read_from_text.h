#pragma once

#include <string>
#include <string_view>

#include "core/io/input_file.h"
#include "core/io/point_io.h"

/// Reads a file that is given as a string.
inline stipple::ReadResult readFromText(const std::string& name, std::string_view content) {
  const stipple::InputFile file(name, std::as_bytes(std::span(content.data(), content.size())));
  stipple::Progress progress;
  return stipple::readPoints(file, progress);
}

/// The message of the error that reading the string throws; empty where none is thrown.
inline std::string errorOfText(const std::string& name, std::string_view content) {
  try {
    readFromText(name, content);
  } catch (const stipple::Error& error) {
    return error.what();
  }
  return {};
}
