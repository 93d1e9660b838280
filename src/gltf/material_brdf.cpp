// BRDFs of extras.steradian, in the place of glTF's own.
#include "gltf/material.hpp"
#include "gltf/warnings.hpp"
#include "scene/conductor.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace sr::gltf {
namespace {

using scene::Model;
using tinygltf::Value;

/// The BRDFs that a property belongs to.
struct Owned {
    const char* property;
    std::vector<Model> owners;
};

void check_properties(const Document& document, const Value& stated, std::optional<Model> model,
                      const std::string& title) {
    static const std::array<Owned, 7> all{{{"roughness_across", {Model::ggx, Model::conductor}},
                                           {"exponent", {Model::phong, Model::blinn_phong}},
                                           {"specular_color", {Model::phong, Model::blinn_phong}},
                                           {"metal", {Model::conductor}},
                                           {"complex_ior", {Model::conductor}},
                                           {"ior_spectrum", {Model::conductor}},
                                           {"file", {Model::merl}}}};
    for (const Owned& owned : all) {
        if (!stated.Has(owned.property)) continue;
        if (model && std::ranges::find(owned.owners, *model) != owned.owners.end()) continue;
        std::vector<std::string_view> names;
        for (const Model owner : owned.owners) names.push_back(scene::name_of(owner));
        document.fail(
            fmt::format("{} has {}", title, owned.property),
            fmt::format("that belongs to the brdf {}: say so, or leave it out", fmt::join(names, " or ")));
    }
}

/// Far around those of all materials; within, the fourth powers of Fresnel's equations are floats.
bool is_index(double n, double k) { return n >= 0.999e-3 && n <= 1e3 && k >= 0.0 && k <= 1e3; }
constexpr const char* index_remedy = "give n from 0.001 to 1000 and k from 0 to 1000";

scene::IorSpectrum spectrum_in(const Document& document, const Value& list, const std::string& title) {
    scene::IorSpectrum spectrum;
    for (int i = 0; i < static_cast<int>(list.ArrayLen()); ++i) {
        const Value& point = list.Get(i);
        spectrum.push_back({point.Get(0).GetNumberAsDouble(), point.Get(1).GetNumberAsDouble(),
                            point.Get(2).GetNumberAsDouble()});
        if (!is_index(spectrum.back().n, spectrum.back().k))
            document.fail(fmt::format("{}: ior_spectrum has n = {} and k = {}", title, spectrum.back().n,
                                      spectrum.back().k),
                          index_remedy);
        if (i > 0 && !(spectrum.back().wavelength > spectrum[spectrum.size() - 2].wavelength))
            document.fail(fmt::format("{}: the wavelengths of ior_spectrum do not ascend", title),
                          "sort its points [nm, n, k]");
    }
    if (spectrum.empty())
        document.fail(fmt::format("{}: ior_spectrum is empty", title), "give points [nm, n, k]");
    return spectrum;
}

scene::ComplexIor ior_in(const Document& document, const Value& stated, const std::string& title) {
    if (stated.Has("metal") + stated.Has("complex_ior") + stated.Has("ior_spectrum") != 1)
        document.fail(fmt::format("{} is a conductor that does not say of what once", title),
                      "give it one of metal, complex_ior and ior_spectrum");
    if (stated.Has("metal"))
        return scene::fitted_ior(*scene::measured_metal(stated.Get("metal").Get<std::string>()));
    if (stated.Has("ior_spectrum"))
        return scene::fitted_ior(spectrum_in(document, stated.Get("ior_spectrum"), title));
    const Value& complex = stated.Get("complex_ior");
    const scene::ComplexIor ior{three_in(complex, "n", vec3(1.0f)), three_in(complex, "k", vec3(0.0f))};
    for (int i = 0; i < 3; ++i)
        if (!is_index(ior.n[i], ior.k[i]))
            document.fail(fmt::format("{}: complex_ior is {} + {}i", title, ior.n[i], ior.k[i]),
                          index_remedy);
    return ior;
}

} // namespace

void MaterialTable::read_brdf(const tinygltf::Material& from, scene::Material& to) {
    const Value* stated = steradian_in(from.extras);
    if (!stated) return;
    const std::string title = fmt::format("material {}", in_quotes(from.name));
    std::optional<Model> model;
    if (stated->Has("brdf")) model = scene::model_named(stated->Get("brdf").Get<std::string>());
    check_properties(document_, *stated, model, title);
    if (!model) return;
    to.model = *model;
    if (stated->Has("roughness_across"))
        to.roughness_across =
            fraction(number_in(*stated, "roughness_across", 0.0), "roughness_across", from.name);
    if (to.model == Model::phong || to.model == Model::blinn_phong) {
        to.exponent = static_cast<float>(number_in(*stated, "exponent", 32.0));
        if (!(to.exponent >= 0.0f && to.exponent <= 1e6f))
            document_.fail(fmt::format("{}: exponent is {}", title, to.exponent), "give one from 0 to 1e6");
        to.specular_color = within(document_, three_in(*stated, "specular_color", vec3(0.04f)), 1.0f,
                                   "specular_color", from.name, "give 0 to 1");
        for (int i = 0; i < 3; ++i)
            if (to.base_color[i] + to.specular_color[i] > 1.0f)
                return warnings_.add(
                    fmt::format("{}: its base colour and specular_color add up to more than 1", title),
                    "it reflects more light than arrives");
    }
    if (to.model == Model::conductor) to.conductor = ior_in(document_, *stated, title);
    if (to.model == Model::merl && !warnings_.attempt("it has glTF's own BRDF", [&] {
            to.measured =
                measured_.number(stated->Has("file") ? stated->Get("file").Get<std::string>() : "", title);
        }))
        to.model = Model::metallic_roughness;
}

} // namespace sr::gltf
