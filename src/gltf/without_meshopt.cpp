// Built where meshoptimizer is not found.
#include "gltf/compression.hpp"

namespace sr::gltf {

bool reads_meshopt() { return false; }
void unpack_meshopt(Document&) {}

} // namespace sr::gltf
