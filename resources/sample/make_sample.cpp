// Makes the bundled sample from Spot (Keenan Crane, public domain): points spread evenly over the surface by
// weighted sample elimination (Yuksel 2015), on curved PN triangles (Vlachos et al. 2001) so that the flat
// facets of the mesh do not show, colored from the texture. The same input gives the same file.
//   make_sample spot_triangulated.obj spot_texture.png spot.ply
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <queue>
#include <random>
#include <unordered_map>
#include <vector>

#include "core/io/obj_file.h"
#include "core/io/point_io.h"
#include "core/io/texture.h"

namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;
using stipple::Index;

constexpr std::size_t kPoints = 80000;
constexpr std::size_t kCandidatesPerPoint = 5;

struct Mesh {
  std::vector<Vector3f> positions, normals;
  std::vector<std::array<stipple::ObjCorner, 3>> triangles;
  std::vector<Vector2f> textureCoordinates;
};

struct Sample {
  Vector3f position, normal;
  Vector2f texture;
};

// The model has y up and looks along -z; here z is up and it looks along -y.
Vector3f turned(const Vector3f& p) {
  return {-p.x(), p.z(), p.y()};
}

Mesh readMesh(const char* path) {
  stipple::Progress progress;
  const stipple::InputFile file(path);
  stipple::ObjFile object = stipple::parseObj(file, progress);
  Mesh mesh;
  for (std::size_t row = 0; row < object.vertices.rows(); ++row) {
    mesh.positions.push_back(turned(
        Eigen::Vector3d(object.vertices.at(row, 0), object.vertices.at(row, 1), object.vertices.at(row, 2))
            .cast<float>()));
  }
  for (std::size_t c = 0; c + 2 < object.corners.size(); c += 3) {
    mesh.triangles.push_back({object.corners[c], object.corners[c + 1], object.corners[c + 2]});
  }
  mesh.textureCoordinates = std::move(object.textureCoordinates);
  mesh.normals.assign(mesh.positions.size(), Vector3f::Zero());
  for (const auto& triangle : mesh.triangles) {
    for (int c = 0; c < 3; ++c) {
      const auto corner = [&](int k) {
        return mesh.positions[triangle[static_cast<std::size_t>((c + k) % 3)].vertex];
      };
      const Vector3f a = corner(1) - corner(0), b = corner(2) - corner(0);
      const Vector3f cross = a.cross(b);
      mesh.normals[triangle[static_cast<std::size_t>(c)].vertex] +=
          cross.normalized() * std::atan2(cross.norm(), a.dot(b));
    }
  }
  for (Vector3f& normal : mesh.normals) normal.normalize();
  return mesh;
}

// A place of a curved triangle: the cubic patch through the corners whose borders are normal to the vertex
// normals.
Vector3f curvedPlace(const std::array<Vector3f, 3>& p, const std::array<Vector3f, 3>& n,
                     const Vector3f& weights) {
  const auto border = [&](std::size_t i, std::size_t j) -> Vector3f {
    return (2 * p[i] + p[j] - (p[j] - p[i]).dot(n[i]) * n[i]) / 3;
  };
  const float u = weights[0], v = weights[1], w = weights[2];
  const Vector3f b210 = border(0, 1), b120 = border(1, 0), b021 = border(1, 2), b012 = border(2, 1),
                 b102 = border(2, 0), b201 = border(0, 2);
  const Vector3f edges = (b210 + b120 + b021 + b012 + b102 + b201) / 6, corners = (p[0] + p[1] + p[2]) / 3;
  const Vector3f b111 = edges + (edges - corners) / 2;
  return p[0] * u * u * u + p[1] * v * v * v + p[2] * w * w * w + 3 * (b210 * u * u * v + b120 * u * v * v) +
         3 * (b201 * u * u * w + b102 * u * w * w) + 3 * (b021 * v * v * w + b012 * v * w * w) +
         6 * b111 * u * v * w;
}

double area(const Mesh& mesh, std::size_t t) {
  const auto& [a, b, c] = mesh.triangles[t];
  const Vector3f& origin = mesh.positions[a.vertex];
  return 0.5 * (mesh.positions[b.vertex] - origin).cross(mesh.positions[c.vertex] - origin).norm();
}

std::vector<Sample> randomSamples(const Mesh& mesh, std::size_t count) {
  std::vector<double> sums;
  double sum = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) sums.push_back(sum += area(mesh, t));
  std::mt19937 random(1);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  std::vector<Sample> samples;
  for (std::size_t s = 0; s < count; ++s) {
    const auto found = std::upper_bound(sums.begin(), sums.end(), uniform() * sum);
    const auto& triangle = mesh.triangles[std::min<std::size_t>(found - sums.begin(), sums.size() - 1)];
    const double root = std::sqrt(uniform()), share = uniform();
    const Vector3f weights(static_cast<float>(1 - root), static_cast<float>(root * (1 - share)),
                           static_cast<float>(root * share));
    std::array<Vector3f, 3> positions, normals;
    Sample sample{Vector3f::Zero(), Vector3f::Zero(), Vector2f::Zero()};
    for (std::size_t c = 0; c < 3; ++c) {
      positions[c] = mesh.positions[triangle[c].vertex];
      normals[c] = mesh.normals[triangle[c].vertex];
      sample.normal += weights[static_cast<Eigen::Index>(c)] * normals[c];
      sample.texture += weights[static_cast<Eigen::Index>(c)] * mesh.textureCoordinates[triangle[c].texture];
    }
    sample.position = curvedPlace(positions, normals, weights);
    sample.normal.normalize();
    samples.push_back(sample);
  }
  return samples;
}

// Pairs of samples nearer than a radius, through cells of that size.
class Neighbors {
 public:
  Neighbors(const std::vector<Sample>& samples, float radius) : samples_(samples), radius_(radius) {
    for (Index s = 0; s < samples.size(); ++s) cells_[key(cellOf(s))].push_back(s);
  }

  void forEach(Index sample, const auto& action) const {
    const Eigen::Vector3i center = cellOf(sample);
    for (int x = -1; x <= 1; ++x) {
      for (int y = -1; y <= 1; ++y) {
        for (int z = -1; z <= 1; ++z) {
          const auto cell = cells_.find(key(center + Eigen::Vector3i(x, y, z)));
          if (cell == cells_.end()) continue;
          for (const Index other : cell->second) {
            const float distance = (samples_[other].position - samples_[sample].position).norm();
            if (other != sample && distance < radius_) action(other, distance);
          }
        }
      }
    }
  }

 private:
  Eigen::Vector3i cellOf(Index sample) const {
    return (samples_[sample].position / radius_).array().floor().cast<int>();
  }
  static std::int64_t key(const Eigen::Vector3i& cell) {
    return ((std::int64_t{cell.x()} << 42) ^ (std::int64_t{cell.y()} << 21)) + cell.z();
  }

  const std::vector<Sample>& samples_;
  float radius_;
  std::unordered_map<std::int64_t, std::vector<Index>> cells_;
};

// Removes the most crowded sample again and again until `count` are left.
std::vector<Sample> eliminate(const std::vector<Sample>& samples, std::size_t count, double surface) {
  // The largest radius that discs of this number can have on this area.
  const auto radius =
      static_cast<float>(std::sqrt(surface / (2 * std::sqrt(3.0) * static_cast<double>(count))));
  const auto weight = [&](float distance) { return std::pow(1 - distance / (2 * radius), 8); };
  const Neighbors neighbors(samples, 2 * radius);
  std::vector<double> crowding(samples.size(), 0);
  std::priority_queue<std::pair<double, Index>> queue;
  for (Index s = 0; s < samples.size(); ++s) {
    neighbors.forEach(s, [&](Index, float distance) { crowding[s] += weight(distance); });
    queue.emplace(crowding[s], s);
  }
  std::vector<char> gone(samples.size(), 0);
  for (std::size_t left = samples.size(); left > count;) {
    const auto [value, sample] = queue.top();
    queue.pop();
    if (gone[sample] || value != crowding[sample]) continue;  // an entry from before a neighbor went
    gone[sample] = 1;
    --left;
    neighbors.forEach(sample, [&](Index other, float distance) {
      if (gone[other]) return;
      crowding[other] -= weight(distance);
      queue.emplace(crowding[other], other);
    });
  }
  std::vector<Sample> kept;
  for (Index s = 0; s < samples.size(); ++s) {
    if (!gone[s]) kept.push_back(samples[s]);
  }
  return kept;
}

void makeSample(const char* meshPath, const char* texturePath, const char* output) {
  const Mesh mesh = readMesh(meshPath);
  const stipple::Texture texture(texturePath);
  double surface = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) surface += area(mesh, t);
  const std::vector<Sample> samples =
      eliminate(randomSamples(mesh, kPoints * kCandidatesPerPoint), kPoints, surface);
  std::vector<Vector3f> positions, normals;
  std::vector<stipple::Rgba8> colors;
  for (const Sample& sample : samples) {
    positions.push_back(sample.position);
    normals.push_back(sample.normal);
    const Vector3f color = texture.sample(sample.texture.x(), sample.texture.y());
    const auto byte = [&](int c) { return static_cast<std::uint8_t>(std::lround(color[c])); };
    colors.push_back({byte(0), byte(1), byte(2)});
  }
  stipple::PointSet points(std::move(positions));
  points.set("normal", std::move(normals));
  points.set("color", std::move(colors));
  stipple::Progress progress;
  stipple::writePoints(output, points, {}, progress);
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 4) {
    std::fprintf(stderr, "usage: make_sample MESH.obj TEXTURE.png OUT.ply\n");
    return 2;
  }
  try {
    makeSample(arguments[1], arguments[2], arguments[3]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
