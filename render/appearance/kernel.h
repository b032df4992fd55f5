#pragma once

/// What all back ends and shaders/frame.glsl agree on about how surfaces become pixels.
namespace stipple::kernel {

/// A disc seen edge-on is turned towards the viewer until its normal makes this cosine with the line of
/// sight.
inline constexpr float kLeastCosine = 0.1f;
/// Of a picture that is one frame, and of frames that are shifted by parts of a pixel and averaged.
struct Footprint {
  /// A disc hides what is behind it only up to this q, its squared distance from the center over the squared
  /// radius: enough to cover, without standing out over contours and creases.
  float visibleShare;
  /// Screen-space kernel, pixels, of the smallest discs. It shrinks by as much as the disc's own radius on
  /// the screen exceeds smallDiscPx, down to the least: what is drawn large enough covers pixels by itself.
  float screenRadiusPx, smallDiscPx, leastScreenRadiusPx;
};
/// At visibleShare the kernel just reaches a pixel center wherever it lies; the least is a line of one pixel
/// for a sheet seen edge-on.
inline constexpr Footprint kOfOneFrame{
    .visibleShare = 0.9f, .screenRadiusPx = 0.75f, .smallDiscPx = 0.7f, .leastScreenRadiusPx = 0.53f};
/// Frames of a mean need not cover pixels, only their share of them: a kernel that reaches pixel centers
/// would widen every contour by half a pixel. Single points keep the area of a pixel.
inline constexpr Footprint kOfManyFrames{
    .visibleShare = 0.8f, .screenRadiusPx = 0.62f, .smallDiscPx = 0.2f, .leastScreenRadiusPx = 0.2f};
constexpr const Footprint& footprintOf(bool isOneOfMany) {
  return isOneOfMany ? kOfManyFrames : kOfOneFrame;
}
/// A fragment counts up to this many of its own radii behind the visible surface, and with a normal within 60
/// degrees.
inline constexpr float kDepthBand = 1.5f;
inline constexpr float kNormalCosine = 0.5f;
/// Weight at q in [0, 1]: (1 - q)^2, in frames of a mean its square, at least this.
inline constexpr float kLeastWeight = 1e-4f;
/// How far selected points take on the color of the selection.
inline constexpr float kSelectionShare = 0.6f;
/// Eye-dome lighting: exp(-this * strength * r) for a neighbor that is r picture heights nearer.
inline constexpr float kEdgeStrength = 0.2f;
/// Width of the line of the brush's ring, and how much the surface inside takes on its color.
inline constexpr float kRingPx = 1.5f, kRingFill = 0.12f;

}  // namespace stipple::kernel
