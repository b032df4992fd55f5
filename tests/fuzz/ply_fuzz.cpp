#include "core/io/ply_reader.h"
#include "tests/fuzz/fuzz_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* bytes, std::size_t size) {
  return stipple::fuzzReader(stipple::readPly, "fuzz.ply", bytes, size);
}
