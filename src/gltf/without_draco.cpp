// Built where Draco is not found.
#include "gltf/compression.hpp"

namespace sr::gltf {

bool reads_draco() { return false; }
void unpack_draco(Document&) {}

} // namespace sr::gltf
