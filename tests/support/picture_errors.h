#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/appearance/image.h"
#include "tests/support/reference_picture.h"

namespace stipple {

class Renderer;

/// A picture of ours, or of a program that we compare with.
struct DrawnPicture {
  Image image;
  std::vector<float> depth;  ///< along the view direction; kNoDepth where the background shows
};

/// The last frame of a renderer.
DrawnPicture takePicture(Renderer& renderer);

/// Mask by pixel: grown (or shrunk) by one pixel in all eight directions; beyond the border there is nothing.
std::vector<std::uint8_t> dilate(const std::vector<std::uint8_t>& mask, int width, int height);
std::vector<std::uint8_t> erode(const std::vector<std::uint8_t>& mask, int width, int height);

/// Peak signal-to-noise ratio (dB) of the 8-bit sRGB values where the mask is set; 99 where nothing differs.
double psnr(const Image& a, const Image& b, const std::vector<std::uint8_t>& mask);

/// Mean structural similarity of the luma (Wang et al. 2004: Gaussian windows of 11 x 11, deviation 1.5) of
/// the windows that lie wholly in the mask; NaN where there is none.
double ssim(const Image& a, const Image& b, const std::vector<std::uint8_t>& mask);

/// Mean absolute difference of the 8-bit values (0 to 255) where the mask is set; 0 where it is empty.
double meanDifference(const Image& a, const Image& b, const std::vector<std::uint8_t>& mask);

struct PictureErrors {
  double psnr = 0;           ///< dB, where all samples of the reference meet the surface
  double psnrWithEdges = 0;  ///< dB, where any sample does, or ours is covered
  double ssim = 0;
  int covered = 0;  ///< pixels that psnr is about
  int holes = 0;    ///< background in ours, although the surface covers the pixel and its eight neighbors
  int fringe = 0;   ///< covered in ours, although the surface covers neither the pixel nor its neighbors
  int seeThrough =
      0;  ///< ours lies more than `tolerance` behind the farthest surface of the pixel and its neighbors
};

/// `depthTolerance` in world units.
PictureErrors comparePictures(const ReferencePicture& reference, const DrawnPicture& drawn,
                              float depthTolerance);

}  // namespace stipple
