#include <fmt/format.h>

#include <Eigen/Geometry>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/cli/command.h"
#include "app/cli/files.h"
#include "core/geometry/neighborhoods.h"

namespace stipple {
namespace {

using Json = nlohmann::ordered_json;

struct InfoOptions {
  std::string input;
  bool json = false;
};

// The smallest and the largest of the numbers that `number` takes from each row, null where none is finite.
template <class Values, class Number>
std::pair<Json, Json> findRange(const Values& values, Number&& number) {
  std::optional<double> low, high;
  for (const auto& value : values) {
    const double v = number(value);
    if (std::isnan(v)) continue;
    low = std::min(low.value_or(v), v);
    high = std::max(high.value_or(v), v);
  }
  const auto toJson = [](const std::optional<double>& v) { return v ? Json(*v) : Json(nullptr); };
  return {toJson(low), toJson(high)};
}

// Whole numbers stay whole.
template <class Values, class Number>
std::pair<Json, Json> findWholeRange(const Values& values, Number&& number) {
  if (values.empty()) return {nullptr, nullptr};
  const auto [low, high] = std::ranges::minmax(values, {}, number);
  return {std::int64_t(number(low)), std::int64_t(number(high))};
}

template <class T>
std::pair<Json, Json> rangeOf(const std::vector<T>& values, const FileProperty& file) {
  if constexpr (std::is_same_v<T, Eigen::Vector3f> || std::is_same_v<T, Rgba8>) {
    Json low = Json::array(), high = Json::array();
    const auto addChannel = [&](std::pair<Json, Json> range) {
      low.push_back(std::move(range.first));
      high.push_back(std::move(range.second));
    };
    if constexpr (std::is_same_v<T, Rgba8>) {
      for (const auto channel : {&Rgba8::r, &Rgba8::g, &Rgba8::b}) {
        addChannel(findWholeRange(values, [&](const Rgba8& color) { return color.*channel; }));
      }
      if (file.hasAlpha) addChannel(findWholeRange(values, [](const Rgba8& color) { return color.a; }));
    } else {
      for (int axis = 0; axis < 3; ++axis) {
        addChannel(findRange(values, [&](const Eigen::Vector3f& v) { return double(v[axis]); }));
      }
    }
    return {std::move(low), std::move(high)};
  } else if constexpr (std::is_integral_v<T>) {
    return findWholeRange(values, [](T v) { return v; });
  } else {
    return findRange(values, [](T v) { return double(v); });
  }
}

Json describe(const Attribute& attribute) {
  auto [low, high] = std::visit([&](const auto& values) { return rangeOf(values, attribute.file); },
                                attribute.column.values());
  return {{"name", attribute.name},
          {"type", nameOf(attribute.type())},
          {"min", std::move(low)},
          {"max", std::move(high)}};
}

Json boundsOf(const PointSet& points) {
  if (points.size() == 0) return nullptr;
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& p : points.positions()) box.extend(p);
  const auto inFile = [&](const Eigen::Vector3f& corner) {
    const Eigen::Vector3d p = points.origin() + corner.cast<double>();
    return Json{p.x(), p.y(), p.z()};
  };
  return {{"min", inFile(box.min())}, {"max", inFile(box.max())}};
}

Json describe(const ReadResult& read) {
  const Sites sites = weldAndOrder(read.points.positions());
  Json attributes = Json::array();
  for (const Attribute& attribute : read.points.attributes()) attributes.push_back(describe(attribute));
  return {{"points", read.points.size()},
          {"dropped", read.dropped},
          {"duplicates", read.points.size() - sites.size()},
          {"triangles", read.points.triangles().size()},
          {"bounds", boundsOf(read.points)},
          {"spacing", sites.size() < 2 ? Json(nullptr) : Json(medianSpacing(sites))},
          {"attributes", std::move(attributes)}};
}

std::string asText(const Json& info) {
  std::string text;
  for (const char* key : {"points", "dropped", "duplicates", "triangles", "spacing"}) {
    text += fmt::format("{:<11} {}\n", key, info[key].dump());
  }
  if (info["bounds"].is_object()) {
    text += fmt::format("{:<11} {} to {}\n", "bounds", info["bounds"]["min"].dump(),
                        info["bounds"]["max"].dump());
  }
  for (const Json& attribute : info["attributes"]) {
    text +=
        fmt::format("{:<11} {} ({}) from {} to {}\n", "attribute", attribute["name"].get<std::string>(),
                    attribute["type"].get<std::string>(), attribute["min"].dump(), attribute["max"].dump());
  }
  return text;
}

Outcome runInfo(const InfoOptions& options, Progress& progress) {
  const ReadResult read = readInput(options.input, progress);
  const Json info = describe(read);
  return makeOutcome(options.json, info, asText(info), read.warnings);
}

}  // namespace

void addInfo(CLI::App& program, Command& chosen) {
  const auto options = std::make_shared<InfoOptions>();
  CLI::App* command = program.add_subcommand("info", "Say what a file holds");
  command->add_option("FILE", options->input, "File of points")->required();
  command->add_flag("--json", options->json, "Print one JSON document");
  command->callback([options, &chosen] { chosen = [options](Progress& p) { return runInfo(*options, p); }; });
}

}  // namespace stipple
