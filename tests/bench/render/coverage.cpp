#include "tests/support/coverage.h"

#include <fmt/format.h>

#include <filesystem>

#include "core/io/point_io.h"
#include "render/hierarchy/splat_radii.h"
#include "tests/bench/render/workbench.h"
#include "tests/support/mesh_caster.h"
#include "tests/support/sampled_hierarchy.h"
#include "tests/support/scans.h"

namespace stipple {

namespace {

void printViews(const std::string& name, const char* radii, const std::vector<CoverageView>& views) {
  int holes = 0, seeThrough = 0, tooMany = 0, fringe = 0, covered = 0;
  for (const CoverageView& view : views) {
    holes += view.errors.holes;
    seeThrough += view.errors.seeThrough;
    tooMany += view.stray() > 3;
    fringe += view.errors.fringe;
    covered += view.errors.covered;
  }
  fmt::print(
      "{:<22} {:<7} {} views: {} holes, {} see-through, {} views with more than 3; fringe {:.2f} %; worst "
      "{}\n",
      name, radii, views.size(), holes, seeThrough, tooMany, 100. * fringe / covered, describeWorst(views));
  std::fflush(stdout);
}

}  // namespace

void printCoverage(Workbench& bench) {
  for (const scenes::Scene& scene : scenes::allScenes()) {
    const Index count = std::min<Index>(bench.options.points, 300'000);
    const Hierarchy hierarchy = sampledHierarchy(scene, count);
    const CoverageSubject subject{hierarchy, scene.surface, static_cast<float>(scene.spacing(count))};
    printViews(scene.name, "blocks", lookFromAllSides(bench.renderer, subject, {}));
  }
  for (const ScannedMesh& scan : scannedMeshes()) {
    const std::filesystem::path path = std::filesystem::path(STIPPLE_TEST_DATA) / scan.path;
    if (!std::filesystem::exists(path)) continue;
    const MeshSubject mesh = loadMesh(path);
    const CoverageSubject blocks{mesh.byBlocks, mesh.truth, mesh.spacing};
    printViews(scan.name, "blocks", lookFromAllSides(bench.renderer, blocks, {}));
    const CoverageSubject fans{mesh.byFans, mesh.truth, mesh.spacing};
    printViews(scan.name, "fans", lookFromAllSides(bench.renderer, fans, {}));
  }
}

}  // namespace stipple
