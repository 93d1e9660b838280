#include "support/random_parts.hpp"

#include <array>

namespace sr::testing {
namespace {

/// LM-63, type C, without symmetry.
constexpr const char* luminaire =
    "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 5 5 1 2 0 0 0\n1 1 10\n0 30 60 90 180\n"
    "0 90 180 270 360\n9 8 5 1 0\n9 7 6 2 0\n9 8 4 1 0\n9 6 3 1 1\n9 8 5 1 0\n";

json light_color(Random& random) {
    return {random.within(0.3, 1.0), random.within(0.3, 1.0), random.within(0.3, 1.0)};
}

json quantity(double value, const char* unit) { return {{"value", value}, {"unit", unit}}; }

void append_punctual(MadeGltf& made, json& node, const char* type, Random& random, const Extremes& extremes) {
    const double distance = extremes.has_extreme_factors ? 1.0 : 2.5;
    json light{{"type", type}, {"color", light_color(random)}};
    light["intensity"] = random.within(4.0, 16.0) * (std::string(type) == "directional" ? 0.3 : 1.0);
    if (std::string(type) != "directional" && random.has_chance(0.4))
        light["range"] = distance * random.within(1.2, 4.0);
    if (std::string(type) == "spot") {
        const double outer = random.within(0.3, 1.2);
        light["spot"] = {{"innerConeAngle", outer * random.within(0.0, 0.9)}, {"outerConeAngle", outer}};
    }
    json& lights = made.root["extensions"]["KHR_lights_punctual"]["lights"];
    node["extensions"]["KHR_lights_punctual"]["light"] = lights.size();
    lights.push_back(light);
}

void append_area(MadeGltf& made, json& node, Random& random) {
    json& lights = made.root["extensions"]["EXT_lights_area"]["lights"];
    node["extensions"]["EXT_lights_area"]["light"] = lights.size();
    lights.push_back({{"type", "rect"},
                      {"color", light_color(random)},
                      {"intensity", random.within(5.0, 30.0)},
                      {"size", random.within(0.3, 1.2)},
                      {"rect", {{"aspect", random.within(0.5, 2.0)}}}});
}

void append_profile(MadeGltf& made, json& node, Random& random) {
    const std::string text = luminaire;
    json& lights = made.root["extensions"]["EXT_lights_ies"]["lights"];
    node["extensions"]["EXT_lights_ies"] = {{"light", lights.size()},
                                            {"multiplier", random.within(0.5, 2.0)}};
    lights.push_back({{"uri", "data:application/octet-stream;base64," + base64({text.begin(), text.end()})}});
}

/// A shape of extras.steradian; what it emits is stated in any of the units.
json shape(Emitter emitter, Random& random) {
    constexpr std::array units{"lm", "cd", "cd/m^2"};
    constexpr std::array least{20.0, 4.0, 6.0};
    const auto unit = static_cast<std::size_t>(random.below(3));
    json stated{{"quantity", quantity(least[unit] * random.within(1.0, 4.0), units[unit])},
                {"visible", random.has_chance(0.7)}};
    if (random.has_chance(0.5)) stated["color"] = light_color(random);
    const auto size = [&] { return random.within(0.3, 1.2); };
    const auto flat = [&] { stated["two_sided"] = random.has_chance(0.3); };
    switch (emitter) {
    case Emitter::rectangle:
    case Emitter::textured_rectangle:
    case Emitter::ellipse:
        stated["shape"] = emitter == Emitter::ellipse ? "ellipse" : "rectangle";
        stated["width"] = size(), stated["height"] = size(), flat();
        break;
    case Emitter::disk: stated["shape"] = "disk", stated["radius"] = 0.6 * size(), flat(); break;
    case Emitter::sphere: stated["shape"] = "sphere", stated["radius"] = 0.3 * size(); break;
    case Emitter::tube:
        stated["shape"] = "tube", stated["radius"] = 0.1 * size(), stated["length"] = size();
        break;
    default:
        stated["shape"] = "polygon", flat();
        for (int i = 0; i < 5; ++i) { // clockwise seen from +Z, so that its front is -Z
            const double angle = -1.25 * (i + random.within(0.0, 0.5));
            stated["corners"].push_back({0.5 * std::cos(angle), 0.5 * std::sin(angle), 0.0});
        }
    }
    if (emitter == Emitter::textured_rectangle) stated["texture"] = static_cast<int>(glow_picture);
    return stated;
}

} // namespace

void append_light(MadeGltf& made, Emitter emitter, int index, Random& random, const Extremes& extremes) {
    json& node = made.root["nodes"][static_cast<std::size_t>(index)];
    switch (emitter) {
    case Emitter::point:
    case Emitter::wide_point: append_punctual(made, node, "point", random, extremes); break;
    case Emitter::spot:
    case Emitter::wide_spot: append_punctual(made, node, "spot", random, extremes); break;
    case Emitter::sun:
    case Emitter::wide_sun: append_punctual(made, node, "directional", random, extremes); break;
    case Emitter::profile: append_profile(made, node, random); break;
    case Emitter::area_rectangle: append_area(made, node, random); break;
    default: node["extras"]["steradian"] = shape(emitter, random);
    }
    if (emitter == Emitter::wide_point || emitter == Emitter::wide_spot)
        node["extras"]["steradian"]["radius"] = random.within(0.05, 0.3);
    if (emitter == Emitter::wide_sun)
        node["extras"]["steradian"]["angular_diameter"] = random.within(0.05, 0.4);
}

} // namespace sr::testing
