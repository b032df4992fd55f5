#include "tests/support/reference_picture.h"

#include <glm/geometric.hpp>

#include "core/parallel.h"
#include "render/appearance/light.h"

namespace stipple {

namespace {

/// Towards the viewer, so that light is two-sided.
glm::dvec3 facing(const glm::dvec3& normal, const scenes::Ray& ray) {
  return glm::dot(normal, ray.direction) > 0 ? -normal : normal;
}

glm::vec3 linearOf(const Rgba8& c) {
  return {linearTable()[c.r], linearTable()[c.g], linearTable()[c.b]};
}

glm::vec3 shadeHit(const scenes::SurfacePoint& hit, const scenes::Ray& ray, const View& view,
                   const Appearance& appearance) {
  const glm::vec3 albedo(linearFromSrgb(float(hit.albedo.x)), linearFromSrgb(float(hit.albedo.y)),
                         linearFromSrgb(float(hit.albedo.z)));
  if (!appearance.lit) return albedo;
  return albedo * light::shade(view.viewFromWorld * glm::vec3(facing(hit.normal, ray)));
}

}  // namespace

scenes::Ray rayThrough(const View& view, const glm::vec2& px) {
  const glm::vec3 through = view.fromPixels(px, 1);
  const glm::dmat3 worldFromView = glm::transpose(glm::dmat3(view.viewFromWorld));
  const glm::dvec3 eye(view.eye);
  if (view.isPerspective()) return {eye, glm::normalize(worldFromView * glm::dvec3(through))};
  return {eye + worldFromView * glm::dvec3(through.x, through.y, 0), worldFromView[2]};
}

ReferencePicture castPicture(const scenes::RaySurface& surface, const View& view,
                             const Appearance& appearance, int samplesPerSide) {
  const std::size_t pixels = static_cast<std::size_t>(view.width) * view.height;
  const Rgba8 background = appearance.background.value_or(Rgba8{0, 0, 0, 0});
  ReferencePicture picture;
  picture.image = {view.width, view.height, std::vector<Rgba8>(pixels)};
  picture.samples = samplesPerSide * samplesPerSide;
  picture.hits.resize(pixels);
  picture.depth.assign(pixels, kNoDepth);
  picture.normals.resize(pixels);

  const auto castPixel = [&](std::size_t pixel) {
    const glm::vec2 corner(pixel % view.width, pixel / view.width);
    const scenes::Ray central = rayThrough(view, corner + 0.5f);
    if (const auto hit = surface.firstHit(central)) {
      picture.depth[pixel] = view.toView(glm::vec3(hit->position)).z;
      picture.normals[pixel] = facing(hit->normal, central);
    }
    glm::vec3 sum(0);
    int hits = 0;
    for (int s = 0; s < picture.samples; ++s) {
      const glm::vec2 within(s % samplesPerSide, s / samplesPerSide);
      const scenes::Ray ray = rayThrough(view, corner + (within + 0.5f) / static_cast<float>(samplesPerSide));
      const auto hit = surface.firstHit(ray);
      if (!hit) continue;
      sum += shadeHit(*hit, ray, view, appearance);
      ++hits;
    }
    const glm::vec3 mean = (sum + static_cast<float>(picture.samples - hits) * linearOf(background)) /
                           static_cast<float>(picture.samples);
    picture.hits[pixel] = static_cast<std::uint8_t>(hits);
    picture.image.pixels[pixel] = {encodeSrgb(mean.x), encodeSrgb(mean.y), encodeSrgb(mean.z),
                                   hits > 0 ? std::uint8_t{255} : background.a};
  };
  parallelFor(pixels, 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t pixel = begin; pixel < end; ++pixel) castPixel(pixel);
  });
  return picture;
}

}  // namespace stipple
