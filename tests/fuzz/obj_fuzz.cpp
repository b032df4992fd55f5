#include "core/io/obj_reader.h"
#include "tests/fuzz/fuzz_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* bytes, std::size_t size) {
  return stipple::fuzzReader(stipple::readObj, "fuzz.obj", bytes, size);
}
