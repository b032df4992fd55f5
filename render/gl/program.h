#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "render/gl/object_name.h"

namespace stipple::gl {

void destroyProgram(unsigned name);

/// A vertex and a fragment shader, compiled and linked.
class Program {
 public:
  Program() = default;
  /// Files of the folder. Throws IoError where one cannot be read or the driver refuses it, naming file and
  /// line.
  Program(const std::filesystem::path& folder, const std::string& vertex, const std::string& fragment);

  void use() const;
  void setUniform(int location, std::uint32_t value);

 private:
  ObjectName<destroyProgram> name_;
};

}  // namespace stipple::gl
