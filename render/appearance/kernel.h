#pragma once

/// What all back ends and shaders/frame.glsl agree on about the footprint of a splat.
namespace stipple::kernel {

/// A disc seen edge-on is turned towards the viewer until its normal makes this cosine with the line of
/// sight.
inline constexpr float kLeastCosine = 0.1f;
/// Screen-space kernel, pixels: just reaches a pixel center wherever it lies.
inline constexpr float kScreenRadiusPx = 0.71f;
/// A fragment counts up to this many of its own radii behind the visible surface, and with a normal within 60
/// degrees.
inline constexpr float kDepthBand = 1.2f;
inline constexpr float kNormalCosine = 0.5f;
/// Weight at q in [0, 1], the squared distance from the center over the squared radius: (1 - q)^2, at least
/// this.
inline constexpr float kLeastWeight = 1e-4f;
/// How far selected points take on the color of the selection.
inline constexpr float kSelectionShare = 0.6f;

}  // namespace stipple::kernel
