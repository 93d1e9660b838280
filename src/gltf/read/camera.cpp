#include "gltf/read/camera.hpp"

#include "gltf/warnings.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace sr::gltf {
namespace {

using glm::dvec3;

// Keeps where it looks (-Z) and which way is up as nearly as it can; scale, shear and mirroring go.
mat4 orthonormalised(const Document& document, const NodeTransform& transform) {
    const dvec3 back(transform.world_from_node[2]);
    const dvec3 up(transform.world_from_node[1]);
    const dvec3 right = glm::cross(up, back);
    if (!(glm::length(back) > 0.0) || !(glm::length(right) > 0.0))
        document.fail(fmt::format("the camera at /nodes/{} is scaled to nothing", transform.node),
                      "give its node a scale that is not zero");
    const dvec3 z = glm::normalize(back);
    const dvec3 x = glm::normalize(right);
    return {glm::vec4(x, 0.0f), glm::vec4(glm::cross(z, x), 0.0f), glm::vec4(z, 0.0f),
            glm::vec4(transform.world_from_node[3])};
}

constexpr float max_yfov = 3.1415f; // the tangent of its half is still a small number

class Claims {
public:
    Claims(const Document& document, int camera) : document_(document), camera_(camera) {}

    void operator()(bool holds, std::string_view property, double value, std::string_view demand) const {
        if (holds) return;
        document_.fail(fmt::format("/cameras/{}: {} is {}", camera_, property, value),
                       fmt::format("it must be {}", demand));
    }

private:
    const Document& document_;
    int camera_ = 0;
};

// tinygltf gives 0 where aspectRatio or zfar is absent.
scene::Perspective perspective(const tinygltf::PerspectiveCamera& from, const Claims& claim) {
    claim(from.yfov > 0.0 && from.yfov < glm::pi<double>(), "yfov", from.yfov, "between 0 and pi");
    claim(from.znear > 0.0, "znear", from.znear, "positive");
    claim(from.aspectRatio >= 0.0, "aspectRatio", from.aspectRatio, "positive");
    claim(from.zfar == 0.0 || from.zfar > from.znear, "zfar", from.zfar, "beyond znear");
    scene::Perspective to;
    to.yfov = std::min(static_cast<float>(from.yfov), max_yfov);
    to.znear = static_cast<float>(from.znear);
    if (from.aspectRatio > 0.0) to.aspect_ratio = static_cast<float>(from.aspectRatio);
    if (from.zfar > 0.0) to.zfar = static_cast<float>(from.zfar);
    return to;
}

scene::Orthographic orthographic(const tinygltf::OrthographicCamera& from, const Claims& claim) {
    claim(from.xmag > 0.0, "xmag", from.xmag, "positive");
    claim(from.ymag > 0.0, "ymag", from.ymag, "positive");
    claim(from.znear >= 0.0, "znear", from.znear, "zero or positive");
    claim(from.zfar > from.znear, "zfar", from.zfar, "beyond znear");
    return {static_cast<float>(from.xmag), static_cast<float>(from.ymag), static_cast<float>(from.znear),
            static_cast<float>(from.zfar)};
}

} // namespace

scene::Camera parse_camera(const Document& document, const NodeTransform& transform) {
    const tinygltf::Node& node = document.model.nodes[static_cast<std::size_t>(transform.node)];
    const tinygltf::Camera& from = document.model.cameras[static_cast<std::size_t>(node.camera)];
    const Claims claim(document, node.camera);
    scene::Camera camera;
    camera.name = from.name.empty() ? node.name : from.name;
    camera.world_from_camera = orthonormalised(document, transform);
    if (from.type == "perspective")
        camera.projection = perspective(from.perspective, claim);
    else
        camera.projection = orthographic(from.orthographic, claim);
    return camera;
}

} // namespace sr::gltf
