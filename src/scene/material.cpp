#include "scene/material.hpp"

#include <algorithm>

namespace sr::scene {

int wrapped(int i, int size, Wrap wrap) {
    if (wrap == Wrap::clamp_to_edge) return std::clamp(i, 0, size - 1);
    const int period = wrap == Wrap::repeat ? size : 2 * size;
    const int m = (i % period + period) % period;
    return m < size ? m : 2 * size - 1 - m;
}

} // namespace sr::scene
