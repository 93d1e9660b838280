#include "scene/camera.hpp"

#include <algorithm>
#include <cmath>

namespace sr::scene {

vec2 half_extent(const Camera& camera, float aspect) {
    vec2 own;
    if (const auto* p = std::get_if<Perspective>(&camera.projection)) {
        own.y = std::tan(0.5f * p->yfov);
        own.x = own.y * p->aspect_ratio.value_or(aspect);
    } else {
        const auto& o = std::get<Orthographic>(camera.projection);
        own = {o.xmag, o.ymag};
    }
    return {std::max(own.x, own.y * aspect), std::max(own.y, own.x / aspect)};
}

} // namespace sr::scene
