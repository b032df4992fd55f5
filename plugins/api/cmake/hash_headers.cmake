# Writes OUTPUT with a hash of VERSION and of the public headers under SOURCE: their names and contents, in order.
file(GLOB_RECURSE headers RELATIVE ${SOURCE} ${SOURCE}/core/*.h ${SOURCE}/plugins/api/*.h)
list(SORT headers)
set(text "${VERSION}")
foreach(header IN LISTS headers)
  file(SHA256 ${SOURCE}/${header} digest)
  string(APPEND text "\n${header} ${digest}")
endforeach()
string(SHA256 digest "${text}")
string(SUBSTRING ${digest} 0 16 digest)
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "#pragma once

#include <cstdint>

namespace stipple {

/// Hash of the version and of all public headers of core and plugins/api.
inline constexpr std::uint64_t kPublicHeadersHash = 0x@digest@u;

}  // namespace stipple
" @ONLY)
