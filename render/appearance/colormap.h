#pragma once

#include <string>
#include <vector>

#include "core/points/attribute.h"

namespace stipple {

enum class Colormap { kViridis, kTurbo, kBlueToRed, kGray };

/// "viridis", "turbo", "blue-to-red", "gray", in the order of the enumeration.
std::vector<std::string> colormapNames();

/// t in [0, 1], clamped; NaN is mid gray. viridis: Smith and van der Walt 2015; turbo: Mikhailov 2019
/// (polynomial); blue to red: the paper's figures, through white (Moreland 2009, diverging).
Rgba8 mapColor(Colormap map, double t);

/// Well-distinguished colors for labels, repeating after a long period; 0 is gray.
Rgba8 labelColor(std::int64_t label);

/// Round values inside [low, high] for the ticks of a legend, ascending, about `count` of them.
std::vector<double> legendTicks(double low, double high, int count);

}  // namespace stipple
