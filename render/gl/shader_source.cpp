#include "render/gl/shader_source.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <regex>

#include "core/error.h"

namespace stipple::gl {

namespace fs = std::filesystem;

namespace {

// Appends the file's lines to `source`, those of included files between them.
void append(ShaderSource& source, const fs::path& folder, const std::string& name) {
  static const std::regex kInclude(R"(\s*#include\s+"([^"]+)\"\s*)");
  std::ifstream stream(folder / name);
  if (!stream) throw IoError(fmt::format("{}: the shader cannot be read", (folder / name).string()));

  const std::size_t file = source.files.size();
  source.files.push_back(name);
  if (file > 0) source.text += fmt::format("#line 1 {}\n", file);
  std::string line;
  std::smatch match;
  for (int number = 1; std::getline(stream, line); ++number) {
    if (!std::regex_match(line, match, kInclude)) {
      source.text += line + '\n';
      continue;
    }
    const std::string included = match[1];
    if (std::ranges::find(source.files, included) == source.files.end()) append(source, folder, included);
    source.text += fmt::format("#line {} {}\n", number + 1, file);
  }
}

}  // namespace

ShaderSource readShader(const fs::path& folder, const std::string& name) {
  ShaderSource source;
  append(source, folder, name);
  return source;
}

std::string nameFiles(std::string_view log, const std::vector<std::string>& files) {
  static const std::regex kPlace(R"(^((?:ERROR|WARNING): )?(\d+)(?:\((\d+)\) ?|:(\d+)(?:\(\d+\))?)(: .*)$)");
  std::string named;
  for (std::size_t begin = 0; begin < log.size();) {
    const std::size_t end = std::min(log.find('\n', begin), log.size());
    std::string line(log.substr(begin, end - begin));
    begin = end + 1;
    std::smatch match;
    if (std::regex_match(line, match, kPlace)) {
      const std::size_t file = std::stoul(match[2]);
      const std::string number = match[3].matched ? match[3] : match[4];
      if (file < files.size()) line = files[file] + ':' + number + match[5].str();
    }
    named += line + '\n';
  }
  if (!named.empty()) named.pop_back();
  return named;
}

fs::path shaderFolder() {
  Dl_info library{};
  if (dladdr(reinterpret_cast<const void*>(&shaderFolder), &library) == 0 || !library.dli_fname) {
    throw IoError(
        "the folder of the shaders cannot be found: this program does not know where its libraries are");
  }
  // In the build tree as installed: a fixed way from the library's folder.
  return (fs::absolute(library.dli_fname).parent_path() / STIPPLE_SHADERS_FROM_LIBRARY).lexically_normal();
}

}  // namespace stipple::gl
