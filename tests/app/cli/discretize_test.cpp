#include <Eigen/SparseCore>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>
#include <sstream>

#include "tests/app/cli/cli_fixture.h"

namespace stipple {
namespace {

using nlohmann::json;
using testing::HasSubstr;

struct MatrixFile {
  std::string header, firstEntry;
  Eigen::SparseMatrix<double> matrix;
};

// An independent reader; a symmetric file is mirrored.
MatrixFile readMatrix(const std::string& path) {
  MatrixFile file;
  std::ifstream stream(path);
  std::getline(stream, file.header);
  std::string line;
  std::getline(stream, line);
  Eigen::Index rows = 0, columns = 0, entries = 0;
  std::istringstream(line) >> rows >> columns >> entries;
  std::vector<Eigen::Triplet<double>> triplets;
  while (std::getline(stream, line)) {
    if (file.firstEntry.empty()) file.firstEntry = line;
    Eigen::Index row = 0, column = 0;
    double value = 0;
    std::istringstream(line) >> row >> column >> value;
    triplets.emplace_back(row - 1, column - 1, value);
    EXPECT_GE(row, column) << "the lower triangle";
  }
  EXPECT_EQ(static_cast<Eigen::Index>(triplets.size()), entries);
  const auto lower = triplets.size();
  for (std::size_t t = 0; t < lower; ++t) {
    if (triplets[t].row() != triplets[t].col()) {
      triplets.emplace_back(triplets[t].col(), triplets[t].row(), triplets[t].value());
    }
  }
  file.matrix.resize(rows, columns);
  file.matrix.setFromTriplets(triplets.begin(), triplets.end());
  return file;
}

// Random points of the unit sphere, the first of them twice.
std::string sphereFile(int count) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::ostringstream text;
  text << "ply\nformat ascii 1.0\nelement vertex " << count + 1
       << "\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
  std::string first;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d p = Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
    std::ostringstream line;
    line << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    if (i == 0) first = line.str();
    text << line.str();
  }
  return text.str() + first;
}

TEST_F(Cli, DiscretizeWritesBothMatricesInTheOrderOfTheFile) {
  constexpr int kCount = 4000;
  const std::string sphere = write("sphere.ply", sphereFile(kCount));
  const json report =
      runJson({"discretize", sphere, "--json", "--stiffness", path("L.mtx"), "--mass", path("M.mtx")});
  const MatrixFile stiffness = readMatrix(path("L.mtx")), mass = readMatrix(path("M.mtx"));
  EXPECT_EQ(stiffness.header, "%%MatrixMarket matrix coordinate real symmetric");
  EXPECT_EQ(mass.header, "%%MatrixMarket matrix coordinate real general");
  ASSERT_EQ(stiffness.matrix.rows(), kCount + 1);
  ASSERT_EQ(mass.matrix.rows(), kCount + 1);

  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(kCount + 1);
  EXPECT_LT((stiffness.matrix * ones).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_NEAR(ones.dot(mass.matrix * ones), 4 * std::numbers::pi, 0.02 * 4 * std::numbers::pi);
  // The last row is a copy of the first: both carry half of the mass of their place.
  EXPECT_EQ(mass.matrix.coeff(0, 0), mass.matrix.coeff(kCount, kCount));
  // Rows belong to the rows of the file: the first coordinate function x has the Dirichlet energy 8 pi / 3.
  const PointSet points = read("sphere.ply");
  Eigen::VectorXd x(kCount + 1);
  for (int i = 0; i <= kCount; ++i) x[i] = points.positions()[static_cast<std::size_t>(i)].x();
  EXPECT_NEAR(x.dot(stiffness.matrix * x), 8 * std::numbers::pi / 3, 0.02 * 8 * std::numbers::pi / 3);

  EXPECT_EQ(report["points"], kCount + 1);
  for (const char* stage :
       {"read", "order", "neighbors", "frames", "fans", "consensus", "assembly", "total"}) {
    EXPECT_GE(report["seconds"][stage], 0) << stage;
    EXPECT_GE(report["cpu_seconds"][stage], 0) << stage;
  }
  EXPECT_GT(report["peak_bytes"], 1e6);
  for (const char* share : {"open_fans", "certified", "consistent_triangles"}) {
    EXPECT_GE(report[share], 0) << share;
    EXPECT_LE(report[share], 1) << share;
  }
  EXPECT_EQ(report["warnings"], json::array());
}

TEST_F(Cli, DiscretizeWrites17SignificantDigits) {
  const std::string sphere = write("sphere.ply", sphereFile(200));
  EXPECT_EQ(run({"discretize", sphere, "--mass", path("M.mtx")}).exitCode, 0);
  std::istringstream entry(readMatrix(path("M.mtx")).firstEntry);
  std::string row, column, value;
  entry >> row >> column >> value;
  char expected[32];
  std::snprintf(expected, sizeof expected, "%.17g", std::stod(value));
  EXPECT_EQ(value, expected);
}

TEST_F(Cli, DiscretizeIsTheSameForAnyNumberOfThreads) {
  const std::string sphere = write("sphere.ply", sphereFile(3000));
  run({"discretize", sphere, "--stiffness", path("one.mtx"), "--threads", "1"});
  run({"discretize", sphere, "--stiffness", path("all.mtx")});
  std::ostringstream one, all;
  one << std::ifstream(path("one.mtx")).rdbuf();
  all << std::ifstream(path("all.mtx")).rdbuf();
  EXPECT_GT(one.str().size(), 1000u);
  EXPECT_TRUE(one.str() == all.str());
}

TEST_F(Cli, DiscretizeTakesItsOptions) {
  const std::string sphere = write("sphere.ply", sphereFile(500));
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{"--scheme", "paper", "--min-angle", "25"},
        {"--scheme", "element", "--k", "30"},
        {"--metric", "projected"},
        {"--consensus", "off"}}) {
    std::vector<std::string> arguments = {"discretize", sphere, "--json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    EXPECT_EQ(runJson(arguments)["points"], 501) << options.front();
  }
}

TEST_F(Cli, DiscretizeRefusesValuesOutOfRangeAndMissingFaces) {
  const std::string sphere = write("sphere.ply", sphereFile(50));
  EXPECT_THAT(failWith(2, {"discretize", sphere, "--k", "5"}), HasSubstr("k is 5"));
  EXPECT_THAT(failWith(2, {"discretize", sphere, "--min-angle", "11"}), HasSubstr("11"));
  EXPECT_THAT(failWith(2, {"discretize", sphere, "--min-angle", "nan"}), HasSubstr("min-angle"));
  EXPECT_THAT(failWith(2, {"discretize", sphere, "--threads", "-1"}), HasSubstr("--threads"));
  EXPECT_THAT(failWith(1, {"discretize", sphere, "--scheme", "mesh"}), HasSubstr("triangles"));
}

}  // namespace
}  // namespace stipple
