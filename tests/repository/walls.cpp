#include "tests/repository/walls.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

namespace stipple {

namespace {

using Folders = std::vector<std::string>;

bool isIn(const std::string& path, const std::string& folder) {
  return path.starts_with(folder + "/");
}

bool isInOneOf(const std::string& path, const Folders& folders) {
  return std::ranges::any_of(folders, [&](const std::string& folder) { return isIn(path, folder); });
}

// What files of a folder may name of ours. The first folder that holds a file decides; tests may name
// everything.
struct Arrow {
  std::string from;
  Folders to;
};
const std::vector<Arrow> kArrows = {
    {"core", {"core"}},
    {"plugins/api", {"plugins/api", "core"}},
    {"plugins", {"plugins/api", "core"}},  // and its own folder
    {"render/appearance", {"render/appearance", "core"}},
    {"render/hierarchy", {"render/hierarchy", "render/appearance", "core"}},
    {"render/raster", {"render/raster", "render/hierarchy", "render/appearance", "core"}},
    {"render/gl", {"render/gl", "core"}},
    {"render", {"render", "core"}},
    {"app/document", {"app/document", "core", "plugins/api", "render/hierarchy"}},
    {"app/tools", {"app/tools", "app/document", "core", "render/hierarchy"}},
    {"app/panels", {"app/panels", "core", "render/appearance"}},
    {"app/jobs", {"app/jobs", "app/document", "core", "plugins/api"}},
    {"app", {"app", "core", "plugins/api", "render"}},
};

// Headers of others that only some folders may name, or only sources.
struct Foreign {
  std::string what;
  Folders beginnings;
  Folders allowedIn;  // empty: everywhere
  bool inHeaders;
};
const std::vector<Foreign> kForeign = {
    {"Qt", {"Q"}, {"app/window", "tests/gui", "tests/bench/gui"}, true},
    {"GL",
     {"epoxy/", "GL/", "GLES"},
     {"render/gl", "render/splat", "app/window", "tests/bench/render/naive_points"},
     true},
    {"Dear ImGui",
     {"imgui"},
     {"app/panels", "app/window", "tests/app/panels", "tests/bench/overlay_bench", "tests/gui"},
     true},
    {"oneTBB", {"tbb/", "oneapi/"}, {"core/parallel"}, false},
    {"nanoflann", {"nanoflann"}, {}, false},
    {"CGAL", {"CGAL/"}, {}, false},
    {"Highway", {"hwy/"}, {}, false},
    {"CHOLMOD", {"cholmod", "suitesparse/", "Eigen/CholmodSupport"}, {}, false},
    {"CLI11", {"CLI/"}, {}, false},
    {"JSON", {"nlohmann/json.hpp"}, {}, false},
};

// Made by the build, from the root of a folder of its own.
constexpr const char* kGenerated = "plugins/api/build_hash.h";

std::string wallBrokenByOurs(const std::string& path, const std::string& name) {
  if (!repositoryHas(name) && name != kGenerated)
    return path + " names \"" + name + "\", which is not a path from the repository root";
  const auto arrow = std::ranges::find_if(kArrows, [&](const Arrow& a) { return isIn(path, a.from); });
  if (arrow == kArrows.end() || isInOneOf(name, arrow->to)) return {};
  const std::string own = std::filesystem::path(path).parent_path().generic_string();
  if (arrow->from == "plugins" && isIn(name, own)) return {};
  return path + " names " + name + ", which is not below it";
}

}  // namespace

std::string wallBrokenBy(const std::string& path, const Include& include) {
  if (include.quoted) return wallBrokenByOurs(path, include.name);
  for (const Foreign& foreign : kForeign) {
    const auto beginsSo = [&](const std::string& beginning) { return include.name.starts_with(beginning); };
    if (std::ranges::none_of(foreign.beginnings, beginsSo)) continue;
    const auto holds = [&](const std::string& place) { return path.starts_with(place); };
    if (!foreign.allowedIn.empty() && std::ranges::none_of(foreign.allowedIn, holds)) {
      return path + " names <" + include.name + ">: " + foreign.what + " has no place there";
    }
    if (!foreign.inHeaders && path.ends_with(".h")) {
      return path + " names <" + include.name + ">: " + foreign.what + " belongs into .cpp files";
    }
  }
  return {};
}

namespace {

using Graph = std::map<std::string, std::set<std::string>>;

// Depth first; `trail` is the way that led to `room`.
bool leadsIntoCircle(const Graph& graph, const std::string& room, std::set<std::string>& done,
                     std::vector<std::string>& trail) {
  const bool seen = std::ranges::find(trail, room) != trail.end();
  trail.push_back(room);
  if (seen) return true;
  if (done.insert(room).second && graph.contains(room)) {
    for (const std::string& next : graph.at(room)) {
      if (leadsIntoCircle(graph, next, done, trail)) return true;
    }
  }
  trail.pop_back();
  return false;
}

}  // namespace

std::vector<std::string> findCircle(const std::vector<SourceFile>& sources) {
  Graph graph;
  for (const SourceFile& file : sources) {
    for (const Include& include : includesOf(file)) {
      const std::string room = std::filesystem::path(include.name).parent_path().generic_string();
      if (include.quoted && room != file.room()) graph[file.room()].insert(room);
    }
  }
  std::set<std::string> done;
  std::vector<std::string> trail;
  for (const auto& [room, next] : graph) {
    if (leadsIntoCircle(graph, room, done, trail)) {
      trail.erase(trail.begin(), std::ranges::find(trail, trail.back()));
      return trail;
    }
  }
  return {};
}

}  // namespace stipple
