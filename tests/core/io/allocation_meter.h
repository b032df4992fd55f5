#pragma once

#include <cstddef>

/// Bytes that `new` holds now, and the most it ever held since the reset, in a test program that links
/// allocation_meter.cpp.
std::size_t allocatedBytes();
std::size_t peakAllocatedBytes();
void resetPeakAllocatedBytes();
