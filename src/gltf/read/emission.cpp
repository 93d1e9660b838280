#include "gltf/read/emission.hpp"

#include "gltf/warnings.hpp"

#include <cmath>
#include <fmt/format.h>

namespace sr::gltf {
namespace {

using glm::dvec3;

PhotometricValue parse_quantity(const Document& document, const json& authored, const std::string& title) {
    const std::string unit = text_in(authored, "unit"); // the schema has all units
    const PhotometricValue quantity{number_in(authored, "value", 0.0), *scene::unit_named(unit)};
    if (!(quantity.value >= 0.0))
        document.fail(fmt::format("{} has the quantity {} {}", title, quantity.value, unit),
                      "give zero or more");
    return quantity;
}

scene::LightColor parse_color(const Document& document, const json& object, const std::string& title) {
    const dvec3 rgb = three_in(object, "color", dvec3(1.0));
    if (!(rgb.x >= 0.0 && rgb.y >= 0.0 && rgb.z >= 0.0 && rgb.x + rgb.y + rgb.z > 0.0))
        document.fail(fmt::format("{} has the colour {} {} {}", title, rgb.x, rgb.y, rgb.z),
                      "give zero or more, and one above zero");
    return {scene::with_unit_luminance(rgb)};
}

scene::LightColor blackbody(const Document& document, double temperature, const std::string& title) {
    constexpr double min_temperature = 500.0,
                     max_temperature = 1e6; // [K]; colder ones do not glow, and hotter ones look the same
    if (!(temperature >= min_temperature && temperature <= max_temperature))
        document.fail(fmt::format("{} has the temperature {} K", title, temperature),
                      fmt::format("give one from {} to {} K", min_temperature, max_temperature));
    return scene::color_of_blackbody(temperature);
}

scene::LightColor spectral(const Document& document, const json& list, const std::string& title) {
    const auto fail = [&](std::string_view problem, std::string_view remedy) {
        document.fail(fmt::format("the spectrum of {} {}", title, problem), remedy);
    };
    scene::Spectrum spectrum;
    for (std::size_t i = 0; i < list.size(); ++i) {
        spectrum.push_back({list[i][0].get<double>(), list[i][1].get<double>()});
        if (!(spectrum.back().value >= 0.0)) fail("has a negative value", "give zero or more");
        if (i > 0 && !(spectrum[i].wavelength > spectrum[i - 1].wavelength))
            fail("has wavelengths that do not ascend", "sort its pairs [nm, value]");
    }
    if (spectrum.size() < 2) fail("has fewer than two points", "give pairs [nm, value] that span the light");
    if (!(scene::xyz_of(spectrum).y > 0.0))
        fail("has nothing between 360 and 830 nm", "give wavelengths in nanometres");
    return scene::color_of(spectrum);
}

} // namespace

scene::UnitSystem unit_system_of(const Document& document) {
    const json* asset = steradian_in(document.root.at("asset"));
    const bool is_radiometric = asset && text_in(*asset, "units") == "radiometric";
    return is_radiometric ? scene::UnitSystem::radiometric : scene::UnitSystem::photometric;
}

EmissionSpec parse_emission(const Document& document, const json* object, const std::string& title) {
    EmissionSpec emission;
    if (!object) return emission;
    if (object->contains("quantity"))
        emission.quantity = parse_quantity(document, object->at("quantity"), title);
    if (object->contains("color") + object->contains("temperature") + object->contains("spectrum") > 1)
        document.fail(fmt::format("{} has two of color, temperature and spectrum", title), "leave one");
    if (object->contains("color")) emission.color = parse_color(document, *object, title);
    if (object->contains("temperature"))
        emission.color = blackbody(document, number_in(*object, "temperature", 0.0), title);
    if (object->contains("spectrum")) emission.color = spectral(document, object->at("spectrum"), title);
    return emission;
}

vec3 as_floats(const Document& document, dvec3 rgb, const std::string& title) {
    const vec3 floats(rgb);
    if (!std::isfinite(floats.x) || !std::isfinite(floats.y) || !std::isfinite(floats.z))
        document.fail(fmt::format("{} is brighter than 32-bit floats can say", title), "lower its intensity");
    return floats;
}

vec3 emitted(const Document& document, const EmissionSpec& emission, dvec3 own, const Conversion& conversion,
             const std::string& title, std::string_view takes) {
    const auto hue = [&] {
        return dvec3(emission.color ? emission.color->rgb : scene::with_unit_luminance(own));
    };
    if (!emission.quantity)
        return as_floats(document, emission.color ? hue() * scene::luminance(vec3(own)) : own, title);
    const auto& [value, unit] = *emission.quantity;
    const double efficacy = emission.color ? emission.color->efficacy : scene::lumens_per_watt;
    const double in_scene = scene::converted(value, unit.system, unit_system_of(document), efficacy);
    const std::optional<double> native = conversion(unit.quantity, in_scene);
    if (!native) document.fail(fmt::format("{} is stated in {}", title, scene::name_of(unit)), takes);
    return as_floats(document, hue() * *native, title);
}

dvec3 emitted_color(const Document& document, dvec3 color, double quantity, const std::string& title) {
    if (!(quantity >= 0.0))
        document.fail(fmt::format("{} has the intensity {}", title, quantity), "give zero or more");
    if (!(color.x >= 0.0 && color.y >= 0.0 && color.z >= 0.0))
        document.fail(fmt::format("{} has the colour {} {} {}", title, color.x, color.y, color.z),
                      "give zero or more");
    return color * quantity;
}

} // namespace sr::gltf
