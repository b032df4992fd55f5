#pragma once

/// What all back ends and shaders/frame.glsl agree on about how surfaces become pixels.
namespace stipple::kernel {

/// A disc seen edge-on is turned towards the viewer until its normal makes this cosine with the line of
/// sight.
inline constexpr float kLeastCosine = 0.1f;
/// A disc hides what is behind it only up to this q, its squared distance from the center over the squared
/// radius: enough to cover, without standing out over contours and creases. Less would sharpen creases, but
/// random points with radii from blocks would leave specks.
inline constexpr float kVisibleShare = 0.9f;
/// Screen-space kernel, pixels, of the smallest discs. It shrinks by as much as the disc's own radius on the
/// screen exceeds smallDiscPx, down to the least: what is drawn large enough covers pixels by itself.
struct ScreenKernel {
  float radiusPx, smallDiscPx, leastRadiusPx;
};
/// At kVisibleShare it just reaches a pixel center wherever it lies; the least is a line of one pixel for a
/// sheet seen edge-on.
inline constexpr ScreenKernel kOfOneFrame{.radiusPx = 0.75f, .smallDiscPx = 0.7f, .leastRadiusPx = 0.53f};
/// Frames that are shifted by parts of a pixel and averaged need not cover pixels, only their share of them:
/// a kernel that reaches pixel centers would widen every contour by half a pixel. Single points keep the area
/// of a pixel.
inline constexpr ScreenKernel kOfManyFrames{.radiusPx = 0.62f, .smallDiscPx = 0.2f, .leastRadiusPx = 0.2f};
constexpr const ScreenKernel& screenKernelOf(bool isOneOfMany) {
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
