#include "app/cli/render_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "app/cli/command.h"

namespace stipple {

namespace {

constexpr int kLargestSide = 16384;
constexpr int kMostSupersampling = 16;

[[noreturn]] void refuse(const std::string& option, const std::string& given, const std::string& expected) {
  throw CLI::ValidationError(option, fmt::format("'{}' is not {}", given, expected));
}

// Numbers with one character between them; nothing where the text holds anything else.
template <class Number>
std::optional<std::vector<Number>> parseNumbers(const std::string& text, char between) {
  std::vector<Number> numbers;
  const char *at = text.data(), *end = at + text.size();
  while (true) {
    Number number{};
    if (at != end && *at == '+') ++at;
    const auto [next, error] = std::from_chars(at, end, number);
    if (error != std::errc{}) return std::nullopt;
    if constexpr (std::is_floating_point_v<Number>) {
      if (!std::isfinite(number)) return std::nullopt;
    }
    numbers.push_back(number);
    if (next == end) return numbers;
    if (*next != between) return std::nullopt;
    at = next + 1;
  }
}

float radians(double degrees) {
  return static_cast<float>(degrees * std::numbers::pi / 180);
}

void readSize(const std::string& text, RenderOptions& options) {
  const auto sides = parseNumbers<int>(text, 'x');
  const auto isSide = [](int side) { return side >= 1 && side <= kLargestSide; };
  if (!sides || sides->size() != 2 || !isSide((*sides)[0]) || !isSide((*sides)[1]))
    refuse("--size", text, fmt::format("WIDTHxHEIGHT with sides from 1 to {}", kLargestSide));
  options.width = (*sides)[0];
  options.height = (*sides)[1];
}

void readCamera(const std::string& text, RenderOptions& options) {
  constexpr double kLeastZoom = 1e-3, kMostZoom = 1e6;
  const auto numbers = parseNumbers<double>(text, ',');
  if (!numbers || numbers->size() < 2 || numbers->size() > 3)
    refuse("--camera", text, "YAW,PITCH or YAW,PITCH,ZOOM (degrees)");
  const double pitch = (*numbers)[1], zoom = numbers->size() == 3 ? (*numbers)[2] : 1;
  if (pitch < -90 || pitch > 90) refuse("--camera", text, "a camera with a pitch from -90 to 90 (degrees)");
  if (zoom < kLeastZoom || zoom > kMostZoom)
    refuse("--camera", text, "a camera with a zoom from 0.001 to 1e6");
  // Turns beyond a whole one would cost digits.
  options.camera.yaw = radians(std::remainder((*numbers)[0], 360.0));
  options.camera.pitch = radians(pitch);
  options.camera.zoom = static_cast<float>(zoom);
}

void readRange(const std::string& text, RenderOptions& options) {
  const auto numbers = parseNumbers<double>(text, ',');
  if (!numbers || numbers->size() != 2 || !((*numbers)[0] < (*numbers)[1]))
    refuse("--range", text, "MIN,MAX with MIN less than MAX");
  options.colors.range = {(*numbers)[0], (*numbers)[1]};
}

std::optional<Rgba8> parseHexColor(const std::string& text) {
  std::uint32_t value = 0;
  const char* end = text.data() + text.size();
  const auto [next, error] = std::from_chars(text.data() + 1, end, value, 16);
  if (error != std::errc{} || next != end || (text.size() != 4 && text.size() != 7)) return std::nullopt;
  const auto channel = [&](int place) {
    return text.size() == 7 ? static_cast<std::uint8_t>(value >> (8 * place))
                            : static_cast<std::uint8_t>(17 * ((value >> (4 * place)) & 15));
  };
  return Rgba8{channel(2), channel(1), channel(0), 255};
}

std::optional<Rgba8> parseColor(const std::string& text) {
  if (text == "black") return Rgba8{0, 0, 0, 255};
  if (text == "gray") return Rgba8{128, 128, 128, 255};
  if (text == "white") return Rgba8{255, 255, 255, 255};
  if (text.starts_with('#')) return parseHexColor(text);
  const auto channels = parseNumbers<std::uint8_t>(text, ',');
  if (!channels || channels->size() != 3) return std::nullopt;
  return Rgba8{(*channels)[0], (*channels)[1], (*channels)[2], 255};
}

void readBackground(const std::string& text, RenderOptions& options) {
  options.appearance.background = parseColor(text);
  if (!options.appearance.background && text != "none")
    refuse("--background", text, "none, black, gray, white, #RRGGBB or RED,GREEN,BLUE from 0 to 255");
}

template <class Read>
void addText(CLI::App& command, RenderOptions& options, const char* name, const char* type, const char* help,
             Read read) {
  command
      .add_option_function<std::string>(
          name, [&options, read](const std::string& text) { read(text, options); }, help)
      ->type_name(type);
}

void addAttribute(CLI::App& command, const char* name, std::string& attribute, const char* help) {
  command.add_option(name, attribute, help)->type_name("ATTRIBUTE")->check([](const std::string& given) {
    return given.empty() ? std::string("the name of an attribute is empty") : std::string();
  });
}

// CLI11's own range lets NaN pass.
void addNumber(CLI::App& command, const char* name, float& number, std::pair<double, double> range,
               const std::string& help) {
  const auto read = [name, range, &number](const std::string& text) {
    const auto numbers = parseNumbers<double>(text, ',');
    if (!numbers || numbers->size() != 1 || (*numbers)[0] < range.first || (*numbers)[0] > range.second)
      refuse(name, text, fmt::format("a number from {} to {}", range.first, range.second));
    number = static_cast<float>((*numbers)[0]);
  };
  command.add_option_function<std::string>(name, read, help)->type_name("NUMBER");
}

void addCameraOptions(CLI::App& command, RenderOptions& options) {
  addText(command, options, "--size", "WIDTHxHEIGHT", "Pixels (1280x720)", readSize);
  addText(
      command, options, "--camera", "YAW,PITCH[,ZOOM]",
      "Degrees; yaw about the up axis, counterclockwise from above; pitch down; zoom 1 fits all (30,20,1)",
      readCamera);
  // The words stand in the order of the enumerations.
  addChoice(
      command, "--up", {"y", "z"},
      [&options](std::size_t choice) { options.camera.up = static_cast<UpAxis>(choice); },
      "Axis that points up (z)");
  command.add_flag_callback(
      "--ortho", [&options] { options.camera.projection = Projection::kOrthographic; },
      "Parallel projection");
}

void addColorOptions(CLI::App& command, RenderOptions& options) {
  addAttribute(command, "--color-by", options.colors.attribute,
               "Attribute to show: color, numbers, labels or directions (color)");
  addAttribute(command, "--saturation-by", options.colors.saturationBy,
               "Numbers that fade colors to gray where they are low");
  addAttribute(command, "--highlight", options.colors.selection, "Paint over where this attribute is not 0");
  addChoice(
      command, "--colormap", colormapNames(),
      [&options](std::size_t choice) { options.colors.colormap = static_cast<Colormap>(choice); },
      "For numbers (viridis)");
  addText(command, options, "--range", "MIN,MAX", "Numbers at the ends of the colormap (all there are)",
          readRange);
  addText(command, options, "--background", "COLOR",
          "none, black, gray, white, #RRGGBB or RED,GREEN,BLUE (dark gray)", readBackground);
}

void addSurfaceOptions(CLI::App& command, RenderOptions& options) {
  addChoice(
      command, "--surface", {"splats", "discs", "points", "mesh"},
      [&options](std::size_t choice) {
        options.drawsTriangles = choice == 3;
        if (choice < 3) options.appearance.mode = static_cast<SplatMode>(choice);
      },
      "Blended splats, plain discs, pixels, or the triangles of the file (splats)");
  addAttribute(command, "--glyphs", options.glyphs, "Draw lines along the vectors of this attribute");
  addNumber(command, "--edges", options.appearance.edgeStrength, {0, 1},
            fmt::format("Darkening at steps in depth, 0 to 1 ({:.1f})", options.appearance.edgeStrength));
  command.add_flag_callback(
      "--one-sided", [&options] { options.appearance.twoSided = false; },
      "Leave what is seen from behind in the dark");
}

void addQualityOptions(CLI::App& command, RenderOptions& options) {
  addChoice(
      command, "--backend", {"auto", "cpu", "gl"},
      [&options](std::size_t choice) { options.backend = static_cast<Backend>(choice); },
      "What draws (auto: gl on graphics hardware, otherwise cpu)");
  addNumber(command, "--tau", options.tau, {0.01, 1000},
            fmt::format("Pixels across of the coarsest splats ({}; down to 2 in a mean of frames)",
                        CutOptions().tau));
  command.add_option("--supersample", options.supersample, "N x N samples a pixel (0: 16 spread ones)")
      ->check(CLI::Range(0, kMostSupersampling));
}

}  // namespace

void addRenderOptions(CLI::App& command, RenderOptions& options) {
  command.add_option("IN", options.input, "File of points")->required();
  addCameraOptions(command, options);
  addColorOptions(command, options);
  addSurfaceOptions(command, options);
  addQualityOptions(command, options);
  command.add_flag("--json", options.json, "Print one JSON document");
}

}  // namespace stipple
