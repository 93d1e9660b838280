#include "support/random_parts.hpp"
#include "unit/image/png_bytes.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <variant>

namespace sr::testing {
namespace {

std::uint8_t byte_of(double value) {
    return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(value, 0.0, 1.0)));
}

using Texel = std::function<glm::dvec4(Random&)>;

void append_picture(MadeGltf& made, int edge, Random& random, const Texel& texel) {
    Png png{static_cast<std::uint32_t>(edge), static_cast<std::uint32_t>(edge), 8, 6, {}, {}, {}};
    for (int row = 0; row < edge; ++row) {
        png.rows.push_back(0);
        for (int column = 0; column < edge; ++column) {
            const glm::dvec4 value = texel(random);
            for (int i = 0; i < 4; ++i) png.rows.push_back(byte_of(value[i]));
        }
    }
    made.root["images"].push_back({{"uri", "data:image/png;base64," + base64(png.bytes())}});
}

/// Appends one texture for each image, all with mipmaps or all without. Software GL compiles every shader
/// again for other samplers, so the scenes of a recipe have few of them, and the recipes together all.
void append_textures(MadeGltf& made, int first_wrap, bool has_mipmaps) {
    constexpr std::array wraps{10497, 33071, 33648};
    constexpr std::array minifications{9987, 9986, 9985, 9984, 9987};
    for (int i = 0; i < picture_count; ++i) {
        const int pair = first_wrap + 2 * i;
        const int magnification = i % 3 == 1 ? 9728 : 9729;
        made.root["samplers"].push_back(
            {{"wrapS", wraps[static_cast<std::size_t>(pair % 3)]},
             {"wrapT", wraps[static_cast<std::size_t>(pair / 3 % 3)]},
             {"magFilter", magnification},
             {"minFilter", has_mipmaps ? minifications[static_cast<std::size_t>(i)] : magnification}});
        made.root["textures"].push_back({{"source", i}, {"sampler", i}});
    }
}

json color(Random& random, double low = 0.1, double high = 0.9) {
    return {random.within(low, high), random.within(low, high), random.within(low, high)};
}

/// A factor between 0 and 1, at the ends of its range if extremes ask for it.
double fraction(Random& random, const Extremes& extremes, double low, double high) {
    if (extremes.has_extreme_factors && random.has_chance(0.5)) return random.below(2);
    return random.within(low, high);
}

json texture(Picture picture, Random& random, const Extremes& extremes) {
    json made{{"index", static_cast<int>(picture)}, {"texCoord", random.below(2)}};
    if (random.has_chance(0.5)) return made;
    const double most = extremes.has_extreme_factors && random.has_chance(0.3) ? 1e6 : 1.5;
    made["extensions"]["KHR_texture_transform"] = {
        {"offset", {random.within(-most, most), random.within(-1, 1)}},
        {"rotation", random.within(-3, 3)},
        {"scale", {random.within(-most, most), random.within(0.5, 1.5)}}};
    return made;
}

/// Fills in one material; the functions are named after the surfaces.
class Maker {
public:
    Maker(json& material, Random& random, const Extremes& extremes)
        : m_(material), random_(random), extremes_(extremes) {}

    void core() {
        json& pbr = m_["pbrMetallicRoughness"];
        pbr["baseColorFactor"] = color(random_);
        pbr["baseColorFactor"].push_back(1.0);
        pbr["metallicFactor"] = fraction(random_, extremes_, 0.0, 1.0);
        pbr["roughnessFactor"] = fraction(random_, extremes_, 0.25, 1.0);
    }

    void make(Surface surface) {
        core();
        switch (surface) {
        case Surface::plain:
        case Surface::colored: break;
        case Surface::textured: textured(); break;
        case Surface::mapped: normal_map(); break;
        case Surface::anisotropic: anisotropic(); break;
        case Surface::coated: coated(); break;
        case Surface::sheen: sheen(); break;
        case Surface::film: film(); break;
        case Surface::masked:
        case Surface::blended: transparent(surface == Surface::masked); break;
        case Surface::unlit: extension("unlit") = json::object(); break;
        case Surface::glowing:
        case Surface::glowing_quad:
        case Surface::textured_glowing: glowing(surface == Surface::textured_glowing); break;
        default: brdf(*model_of(surface)); break;
        }
    }

private:
    json& extension(const char* name) { return m_["extensions"][std::string("KHR_materials_") + name]; }
    json picture(Picture number) { return texture(number, random_, extremes_); }

    /// States the model and each of its parameters.
    void brdf(scene::Model model) {
        json& stated = m_["extras"]["steradian"];
        stated["brdf"] = scene::name_of(model);
        for (const scene::BrdfParameter& parameter : scene::brdf_parameters)
            if (parameter.is_of(model) && !parameter.is_alternative)
                stated[std::string(parameter.key)] =
                    std::visit([&](auto member) { return value_of(parameter, member); }, parameter.member);
    }

    json value_of(const scene::BrdfParameter& parameter, float scene::Material::*) {
        return parameter.max > 1.0f ? random_.within(2.0, 40.0) : fraction(random_, extremes_, 0.25, 1.0);
    }
    /// Leaves to the colour of a lobe what the base colour does not reflect.
    json value_of(const scene::BrdfParameter&, vec3 scene::Material::*) {
        for (int i = 0; i < 3; ++i)
            m_["pbrMetallicRoughness"]["baseColorFactor"][i] = random_.within(0.0, 0.6);
        return color(random_, 0.05, 0.4);
    }
    json value_of(const scene::BrdfParameter&, scene::ComplexIor scene::Material::*) {
        return random_.has_chance(0.5) ? "gold" : "silver";
    }
    /// The name of a file, which no generated scene has.
    json value_of(const scene::BrdfParameter&, int scene::Material::*) { return "brdf.binary"; }

    void normal_map() {
        m_["normalTexture"] = picture(normals_picture);
        m_["normalTexture"]["scale"] = random_.within(0.3, 1.5);
    }

    void textured() {
        m_["pbrMetallicRoughness"]["baseColorTexture"] = picture(colors_picture);
        m_["pbrMetallicRoughness"]["metallicRoughnessTexture"] = picture(data_picture);
        normal_map();
        extension("ior")["ior"] = fraction(random_, extremes_, 1.2, 2.0);
        extension("specular") = {{"specularFactor", fraction(random_, extremes_, 0.2, 1.0)},
                                 {"specularColorFactor", color(random_)},
                                 {"specularTexture", picture(data_picture)},
                                 {"specularColorTexture", picture(colors_picture)}};
    }

    void anisotropic() {
        extension("anisotropy") = {{"anisotropyStrength", random_.within(0.2, 0.9)},
                                   {"anisotropyRotation", random_.within(0.0, 6.0)},
                                   {"anisotropyTexture", picture(data_picture)}};
    }

    void coated() {
        extension("clearcoat") = {{"clearcoatFactor", random_.within(0.2, 1.0)},
                                  {"clearcoatRoughnessFactor", fraction(random_, extremes_, 0.25, 0.9)},
                                  {"clearcoatTexture", picture(data_picture)},
                                  {"clearcoatRoughnessTexture", picture(data_picture)},
                                  {"clearcoatNormalTexture", picture(normals_picture)}};
    }

    void sheen() {
        extension("sheen") = {{"sheenColorFactor", color(random_)},
                              {"sheenRoughnessFactor", fraction(random_, extremes_, 0.3, 1.0)},
                              {"sheenColorTexture", picture(colors_picture)},
                              {"sheenRoughnessTexture", picture(data_picture)}};
    }

    void film() {
        const double least = random_.within(100.0, 300.0);
        extension("iridescence") = {{"iridescenceFactor", random_.within(0.2, 1.0)},
                                    {"iridescenceIor", random_.within(1.2, 1.8)},
                                    {"iridescenceThicknessMinimum", least},
                                    {"iridescenceThicknessMaximum", least + random_.within(50.0, 300.0)},
                                    {"iridescenceTexture", picture(data_picture)},
                                    {"iridescenceThicknessTexture", picture(data_picture)}};
    }

    void transparent(bool is_mask) {
        m_["alphaMode"] = is_mask ? "MASK" : "BLEND";
        m_["pbrMetallicRoughness"]["baseColorTexture"] = picture(alpha_picture);
        m_["pbrMetallicRoughness"]["baseColorFactor"][3] = fraction(random_, extremes_, 0.5, 1.0);
        if (is_mask) m_["alphaCutoff"] = fraction(random_, extremes_, 0.3, 0.6);
    }

    void glowing(bool is_textured) {
        m_["emissiveFactor"] = color(random_, 0.2, 1.0);
        extension("emissive_strength")["emissiveStrength"] = random_.within(2.0, 20.0);
        if (is_textured) m_["emissiveTexture"] = picture(glow_picture);
    }

    json& m_;
    Random& random_;
    const Extremes& extremes_;
};

} // namespace

void append_pictures(MadeGltf& made, int first_wrap, Random& random) {
    const auto middling = [](Random& r) { return r.within(0.3, 0.9); };
    append_picture(made, 4, random,
                   [&](Random& r) { return glm::dvec4(middling(r), middling(r), middling(r), 1.0); });
    append_picture(made, 4, random, [&](Random& r) {
        return glm::dvec4(middling(r), r.within(0.6, 1.0), middling(r), middling(r));
    });
    append_picture(made, 4, random, [](Random& r) {
        const glm::dvec3 n = glm::normalize(glm::dvec3(r.within(-0.4, 0.4), r.within(-0.4, 0.4), 1.0));
        return glm::dvec4(0.5 + 0.5 * n, 1.0);
    });
    append_picture(made, 4, random, [&](Random& r) {
        return glm::dvec4(middling(r), middling(r), middling(r),
                          r.has_chance(0.5) ? r.within(0.0, 0.3) : 1.0);
    });
    append_picture(made, 4, random,
                   [&](Random& r) { return glm::dvec4(middling(r), middling(r), middling(r), 1.0); });
    append_textures(made, first_wrap, random.has_chance(0.5));
}

int append_material(MadeGltf& made, Surface surface, Random& random, const Extremes& extremes) {
    json material;
    Maker(material, random, extremes).make(surface);
    material["doubleSided"] = random.has_chance(0.4);
    made.root["materials"].push_back(material);
    return static_cast<int>(made.root["materials"].size()) - 1;
}

} // namespace sr::testing
