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

// 0 stands for an aspectRatio or a zfar that is absent.
scene::Perspective perspective(const json& from, const Claims& claim) {
    const double yfov = number_in(from, "yfov", 0.0), znear = number_in(from, "znear", 0.0);
    const double aspect_ratio = number_in(from, "aspectRatio", 0.0), zfar = number_in(from, "zfar", 0.0);
    claim(yfov > 0.0 && yfov < glm::pi<double>(), "yfov", yfov, "between 0 and pi");
    claim(znear > 0.0, "znear", znear, "positive");
    claim(aspect_ratio >= 0.0, "aspectRatio", aspect_ratio, "positive");
    claim(zfar == 0.0 || zfar > znear, "zfar", zfar, "beyond znear");
    scene::Perspective to;
    to.yfov = std::min(static_cast<float>(yfov), max_yfov);
    to.znear = static_cast<float>(znear);
    if (aspect_ratio > 0.0) to.aspect_ratio = static_cast<float>(aspect_ratio);
    if (zfar > 0.0) to.zfar = static_cast<float>(zfar);
    return to;
}

scene::Orthographic orthographic(const json& from, const Claims& claim) {
    const double xmag = number_in(from, "xmag", 0.0), ymag = number_in(from, "ymag", 0.0);
    const double znear = number_in(from, "znear", 0.0), zfar = number_in(from, "zfar", 0.0);
    claim(xmag > 0.0, "xmag", xmag, "positive");
    claim(ymag > 0.0, "ymag", ymag, "positive");
    claim(znear >= 0.0, "znear", znear, "zero or positive");
    claim(zfar > znear, "zfar", zfar, "beyond znear");
    return {static_cast<float>(xmag), static_cast<float>(ymag), static_cast<float>(znear),
            static_cast<float>(zfar)};
}

} // namespace

scene::Camera parse_camera(const Document& document, const NodeTransform& transform) {
    const json& node = *transform.source;
    const int number = node.at("camera").get<int>();
    const json& from = document.entry("cameras", number);
    const Claims claim(document, number);
    scene::Camera camera;
    camera.name = text_in(from, "name");
    if (camera.name.empty()) camera.name = text_in(node, "name");
    camera.world_from_camera = orthonormalised(document, transform);
    if (text_in(from, "type") == "perspective")
        camera.projection = perspective(from.at("perspective"), claim);
    else
        camera.projection = orthographic(from.at("orthographic"), claim);
    return camera;
}

} // namespace sr::gltf
