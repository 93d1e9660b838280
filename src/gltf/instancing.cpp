#include "gltf/instancing.hpp"

#include "gltf/accessor.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <optional>

namespace sr::gltf {
namespace {

using tinygltf::Value;

class Attributes {
public:
    Attributes(const Document& document, const Value& attributes, std::string pointer)
        : document_(document), attributes_(attributes), pointer_(std::move(pointer)) {
        for (const char* name : {"TRANSLATION", "ROTATION", "SCALE"})
            if (attributes.Has(name)) count(count_of(document, attributes.Get(name).GetNumberAsInt()));
    }

    std::size_t count() const { return count_.value_or(0); }

    template<int N>
    std::vector<glm::vec<N, float>> read(const char* name, glm::vec<N, float> fallback) const {
        if (!attributes_.Has(name)) return std::vector<glm::vec<N, float>>(count(), fallback);
        auto all = vectors<N>(document_, attributes_.Get(name).GetNumberAsInt());
        for (const auto& v : all)
            for (int i = 0; i < N; ++i)
                if (!std::isfinite(v[i]))
                    document_.fail(fmt::format("{}/{} is not finite", pointer_, name),
                                   "export the file again");
        return all;
    }

private:
    void count(std::size_t elements) {
        if (count_.value_or(elements) != elements)
            document_.fail(
                fmt::format("{} are {} and {}, which differ in number", pointer_, *count_, elements),
                "give as many of each");
        count_ = elements;
    }

    const Document& document_;
    const Value& attributes_;
    std::string pointer_;
    std::optional<std::size_t> count_;
};

} // namespace

std::vector<glm::dmat4> instances_of(const Document& document, int node) {
    const auto& extensions = document.model.nodes[static_cast<std::size_t>(node)].extensions;
    const Value* instancing = extension(extensions, "EXT_mesh_gpu_instancing");
    if (!instancing) return {glm::dmat4(1.0)};
    const std::string pointer = fmt::format("/nodes/{}/extensions/EXT_mesh_gpu_instancing/attributes", node);
    const Attributes attributes(document, instancing->Get("attributes"), pointer);
    const auto translations = attributes.read<3>("TRANSLATION", vec3(0.0f));
    const auto rotations = attributes.read<4>("ROTATION", vec4(0.0f, 0.0f, 0.0f, 1.0f));
    const auto scales = attributes.read<3>("SCALE", vec3(1.0f));
    std::vector<glm::dmat4> result;
    for (std::size_t i = 0; i < attributes.count(); ++i) {
        const vec4 q = rotations[i];
        const glm::dquat rotation(q.w, q.x, q.y, q.z);
        if (!(glm::length(rotation) > 0.0))
            document.fail(pointer + "/ROTATION has a zero", "give unit quaternions");
        const glm::dmat4 turned = glm::translate(glm::dmat4(1.0), glm::dvec3(translations[i]))
                                  * glm::mat4_cast(glm::normalize(rotation));
        result.push_back(glm::scale(turned, glm::dvec3(scales[i])));
    }
    return result;
}

} // namespace sr::gltf
