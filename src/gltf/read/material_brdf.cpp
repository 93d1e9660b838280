#include "gltf/read/material_brdf.hpp"

#include "gltf/uri.hpp"
#include "scene/conductor.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <span>
#include <variant>

namespace sr::gltf {
namespace {

using scene::Model;

/// Far around those of all materials; within, the fourth powers of Fresnel's equations are floats.
bool is_index(double n, double k) { return n >= 0.999e-3 && n <= 1e3 && k >= 0.0 && k <= 1e3; }
constexpr const char* index_remedy = "give n from 0.001 to 1000 and k from 0 to 1000";

scene::IorSpectrum spectrum_in(const Document& document, const json& list, const std::string& title) {
    scene::IorSpectrum spectrum;
    for (const json& point : list) {
        spectrum.push_back({point[0].get<double>(), point[1].get<double>(), point[2].get<double>()});
        if (!is_index(spectrum.back().n, spectrum.back().k))
            document.fail(fmt::format("{}: ior_spectrum has n = {} and k = {}", title, spectrum.back().n,
                                      spectrum.back().k),
                          index_remedy);
        if (spectrum.size() > 1 && !(spectrum.back().wavelength > spectrum[spectrum.size() - 2].wavelength))
            document.fail(fmt::format("{}: the wavelengths of ior_spectrum do not ascend", title),
                          "sort its points [nm, n, k]");
    }
    if (spectrum.empty())
        document.fail(fmt::format("{}: ior_spectrum is empty", title), "give points [nm, n, k]");
    return spectrum;
}

scene::ComplexIor ior_in(const Document& document, const json& stated, const std::string& title) {
    if (stated.contains("metal") + stated.contains("complex_ior") + stated.contains("ior_spectrum") != 1)
        document.fail(fmt::format("{} is a conductor that does not say of what once", title),
                      "give it one of metal, complex_ior and ior_spectrum");
    if (stated.contains("metal")) return scene::fit_ior(*scene::measured_metal(text_in(stated, "metal")));
    if (stated.contains("ior_spectrum"))
        return scene::fit_ior(spectrum_in(document, stated.at("ior_spectrum"), title));
    const json& complex = stated.at("complex_ior");
    const scene::ComplexIor ior{three_in(complex, "n", vec3(1.0f)), three_in(complex, "k", vec3(0.0f))};
    for (int i = 0; i < 3; ++i)
        if (!is_index(ior.n[i], ior.k[i]))
            document.fail(fmt::format("{}: complex_ior is {} + {}i", title, ior.n[i], ior.k[i]),
                          index_remedy);
    return ior;
}

void check_owners(const Document& document, const json& stated, std::optional<Model> model,
                  const std::string& title) {
    for (const scene::BrdfParameter& parameter : scene::brdf_parameters)
        if (stated.contains(parameter.key) && !(model && parameter.is_of(*model)))
            document.fail(fmt::format("{} has {}", title, parameter.key),
                          fmt::format("that belongs to the brdf {}: say so, or leave it out",
                                      scene::models_with(parameter, " or ")));
}

/// Reads one parameter of a BRDF into the member of a material that it is.
struct ParameterReader {
    const Document& document;
    const json& stated;
    const std::string& title;
    MeasuredTable& measured;
    Warnings& warnings;
    scene::Material& to;
    const scene::BrdfParameter& parameter;

    // A fraction is clamped, as glTF's own are.
    void operator()(float scene::Material::*member) const {
        const std::string key(parameter.key);
        if (!stated.contains(key) && !parameter.fallback) return;
        const double value = number_in(stated, key, parameter.fallback.value_or(0.0f));
        const bool is_fraction = parameter.min == 0.0f && parameter.max == 1.0f;
        to.*member = is_fraction ? clamped(value, 0.0, 1.0, key, title, warnings) : static_cast<float>(value);
        if (!(to.*member >= parameter.min && to.*member <= parameter.max))
            document.fail(fmt::format("{}: {} is {}", title, key, to.*member),
                          fmt::format("give one from {} to {}", parameter.min, parameter.max));
    }

    void operator()(vec3 scene::Material::*member) const {
        const std::string key(parameter.key);
        if (!stated.contains(key) && !parameter.fallback) return;
        const vec3 value = three_in(stated, key, vec3(parameter.fallback.value_or(0.0f)));
        to.*member =
            within(document, value, parameter.max, key, title, fmt::format("give 0 to {}", parameter.max));
    }

    void operator()(scene::ComplexIor scene::Material::*member) const {
        to.*member = ior_in(document, stated, title);
    }

    void operator()(int scene::Material::*member) const {
        const std::string key(parameter.key);
        const auto read = [&] { to.*member = measured.number(text_in(stated, key), title); };
        if (!warnings.attempt("it has glTF's own BRDF", read)) to.model = Model::metallic_roughness;
    }
};

} // namespace

int MeasuredTable::number(const std::string& uri, const std::string& title) {
    if (const auto known = number_of_.find(uri); known != number_of_.end()) return known->second;
    if (uri.empty() || is_data_uri(uri))
        document_.fail(fmt::format("{} is measured, and its file is not named", title),
                       R"(name one beside the glTF, as in "file": "gold-paint.binary")");
    const std::vector<std::uint8_t> bytes = read_uri(uri, document_.folder, {document_.name, title});
    brdfs_.push_back(scene::read_merl(std::as_bytes(std::span(bytes)), (document_.folder / uri).string()));
    return number_of_[uri] = static_cast<int>(brdfs_.size()) - 1;
}

void read_brdf(const Document& document, const json& stated, const std::string& title,
               MeasuredTable& measured, Warnings& warnings, scene::Material& to) {
    std::optional<Model> model;
    if (stated.contains("brdf")) model = scene::model_named(text_in(stated, "brdf"));
    check_owners(document, stated, model, title);
    if (!model) return;
    to.model = *model;
    for (const scene::BrdfParameter& parameter : scene::brdf_parameters)
        if (parameter.is_of(*model) && !parameter.is_alternative)
            std::visit(ParameterReader{document, stated, title, measured, warnings, to, parameter},
                       parameter.member);
    if (*model != Model::phong && *model != Model::blinn_phong) return;
    const vec3 sum = vec3(to.base_color) + to.specular_color;
    if (sum.x > 1.0f || sum.y > 1.0f || sum.z > 1.0f)
        warnings.add(fmt::format("{}: its base colour and specular_color add up to more than 1", title),
                     "it reflects more light than arrives");
}

float clamped(double value, double least, double most, std::string_view factor, const std::string& title,
              Warnings& warnings) {
    if (value >= least && value <= most) return static_cast<float>(value);
    warnings.add(fmt::format("{}: {} is {}, outside {} to {}", title, factor, value, least, most),
                 "it is clamped");
    return static_cast<float>(std::clamp(value, least, most));
}

vec3 within(const Document& document, vec3 value, float most, std::string_view factor,
            const std::string& title, const std::string& remedy) {
    for (int i = 0; i < 3; ++i)
        if (!(value[i] >= 0.0f && value[i] <= most))
            document.fail(fmt::format("{}: {} is {} {} {}", title, factor, value.x, value.y, value.z),
                          remedy);
    return value;
}

} // namespace sr::gltf
