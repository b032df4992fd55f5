#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace stipple::gl {

/// A shader's text with the files that it includes put in place, each once (#include "name", a file of the
/// same folder).
struct ShaderSource {
  std::string text;
  std::vector<std::string> files;  ///< names by the number that #line gives them
};

/// Throws IoError where a file cannot be read.
ShaderSource readShader(const std::filesystem::path& folder, const std::string& name);

/// A compiler's messages with file names where the compiler has numbers: "splat.glsl:12: ...". Knows how Mesa
/// ("0:12(5): "), NVIDIA ("0(12) : ") and AMD or Apple ("ERROR: 0:12: ") write.
std::string nameFiles(std::string_view log, const std::vector<std::string>& files);

/// Where the shaders of this installation (or build tree) are, found from the place of this library.
std::filesystem::path shaderFolder();

}  // namespace stipple::gl
