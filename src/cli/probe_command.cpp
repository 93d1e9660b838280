#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/interruption.hpp"
#include "core/math.hpp"
#include "core/output.hpp"
#include "core/text.hpp"
#include "picture/open_scene.hpp"
#include "render/probe.hpp"

#include <CLI/CLI.hpp>
#include <charconv>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>

namespace sr::cli {
namespace {

using nlohmann::ordered_json;

struct PixelPlace {
    int column = 0;
    int row = 0;
};

/// "X,Y"; absent if it is not two whole numbers from 0 up.
std::optional<PixelPlace> parse_place(const std::string& text) {
    PixelPlace place;
    const char* end = text.data() + text.size();
    const auto [comma, first] = std::from_chars(text.data(), end, place.column);
    if (first != std::errc{} || comma == end || *comma != ',') return std::nullopt;
    const auto [last, second] = std::from_chars(comma + 1, end, place.row);
    if (second != std::errc{} || last != end || place.column < 0 || place.row < 0) return std::nullopt;
    return place;
}

struct ProbeCommand {
    RenderSettings rendering;
    PixelPlace pixel;
    bool json = false;
};

ordered_json triple(vec3 v) { return {v.x, v.y, v.z}; }

/// A point in the file's world.
ordered_json place(vec3 p, const scene::Scene& scene) {
    if (scene.origin == glm::dvec3(0.0)) return triple(p);
    const glm::dvec3 world = scene.origin + glm::dvec3(p);
    return {world.x, world.y, world.z};
}

/// "L [cd/m^2]", in the scene's units.
std::string with_unit(const char* symbol, scene::Quantity quantity, const picture::OpenScene& open) {
    return fmt::format("{} [{}]", symbol, scene::name_of({quantity, open.stage.scene.units}));
}

ordered_json as_json(const ProbeCommand& command, const picture::OpenScene& open,
                     const render::PixelTerms& terms) {
    const auto radiance = [&](const char* symbol) {
        return with_unit(symbol, scene::Quantity::radiance, open);
    };
    ordered_json lights = ordered_json::array();
    for (std::size_t k = 0; k < terms.lights.size(); ++k) {
        const render::LightTerms& t = terms.lights[k];
        lights.push_back({{"light", k},
                          {"name", scene::name_of(open.stage.lights[k])},
                          {"shape", scene::variety_of(open.stage.lights[k])},
                          {"solid_angle [sr]", t.solid_angle},
                          {"wi", triple(t.wi)},
                          {"cos_i", t.cos_i},
                          {"f_r [1/sr]", triple(t.f_r)},
                          {"V", t.V},
                          {"V_rgb", triple(t.V_color)},
                          {with_unit("E", scene::Quantity::irradiance, open), triple(t.E)},
                          {radiance("L_r"), triple(t.L_r)}});
    }
    return {{"scene", command.rendering.scene},
            {"pixel", {command.pixel.column, command.pixel.row}},
            {"width", open.size.width},
            {"height", open.size.height},
            {"camera", open.stage.camera.name},
            {"samples", command.rendering.stop.samples},
            {"seed", command.rendering.rendering.seed},
            {"x [m]", place(terms.x, open.stage.scene)},
            {"n", triple(terms.n)},
            {"wo", triple(terms.wo)},
            {"coverage", terms.coverage},
            {radiance("L_e"), triple(terms.L_e)},
            {"lights", lights},
            {radiance("L_o"), triple(terms.L_o)}};
}

std::string cells(vec3 v, int width) {
    return fmt::format("{:>{w}.4g}{:>{w}.4g}{:>{w}.4g}", v.x, v.y, v.z, fmt::arg("w", width));
}

/// A light's name, cut to fit its column.
std::string fitted(const std::string& name) {
    constexpr std::size_t room = 17;
    return name.size() <= room ? name : name.substr(0, room - 3) + "...";
}

std::string row_of(int k, const scene::Light& light, const render::LightTerms& t) {
    const std::string extent = t.solid_angle > 0.0f ? fmt::format("{:.4g}", t.solid_angle) : "-";
    return fmt::format("{:>3} {:<18}{:<12}{:>9} {:>7.3f}{:>7.3f}{:>7.3f}{:>8.4f}{:>8.4f}{:>11.4g}{:>10.4g}{}",
                       k, fitted(scene::name_of(light)), scene::variety_of(light), extent, t.wi.x, t.wi.y,
                       t.wi.z, t.cos_i, t.V, luminance(t.f_r), luminance(t.E), cells(t.L_r, 11));
}

void print(const ProbeCommand& command, const picture::OpenScene& open, const render::PixelTerms& terms) {
    print_data("pixel {},{} of {}x{}, camera '{}', {} samples, seed {}\n\n", command.pixel.column,
               command.pixel.row, open.size.width, open.size.height, shown(open.stage.camera.name),
               command.rendering.stop.samples, command.rendering.rendering.seed);
    const glm::dvec3 x = open.stage.scene.origin + glm::dvec3(terms.x);
    const bool is_far = open.stage.scene.origin != glm::dvec3(0.0); // more digits than four
    print_data("  x   {} m\n  n   {}\n  wo  {}\n\n",
               is_far ? fmt::format("{:>15.10g}{:>15.10g}{:>15.10g}", x.x, x.y, x.z) : cells(terms.x, 11),
               cells(terms.n, 11), cells(terms.wo, 11));
    print_data("  L_o = L_e + Σ E f_r; directions, cosθ, V and f_r are means over the light; f_r and E as "
               "luminance\n\n");
    print_data("    {:<18}{:<12}{:>9} {:>21}{:>8}{:>8}{:>11}{:>10}{:>33}\n", "light", "shape", "Ω [sr]", "wi",
               "cosθ", "V", "f_r [1/sr]", with_unit("E", scene::Quantity::irradiance, open),
               with_unit("L R, G, B", scene::Quantity::radiance, open));
    vec3 sum = terms.L_e;
    for (std::size_t k = 0; k < terms.lights.size(); ++k) {
        print_data("{}\n", shown(row_of(static_cast<int>(k), open.stage.lights[k], terms.lights[k])));
        sum += terms.lights[k].L_r;
    }
    const auto line = [](const char* what, vec3 L) { print_data("    {:<98}{}\n", what, cells(L, 11)); };
    line("L_e, the surface's own emission and the background", terms.L_e);
    line("sum", sum);
    line("L_o, the pixel as render writes it", terms.L_o);
}

ExitStatus probe(const ProbeCommand& command) {
    picture::PhaseTimes times;
    const picture::OpenScene open = picture::open_scene(command.rendering, times);
    if (command.pixel.column >= open.size.width || command.pixel.row >= open.size.height)
        throw CLI::ValidationError("--pixel", fmt::format("'{},{}' is outside the picture of {}x{}",
                                                          command.pixel.column, command.pixel.row,
                                                          open.size.width, open.size.height));
    const render::GpuScene scene = picture::upload(open, command.rendering);
    const Interruption interruption;
    const auto terms =
        render::probe(scene, open.stage.camera, picture::render_options(command.rendering, open.size),
                      command.pixel.column, command.pixel.row, interruption.token());
    open.context->require_silence();
    if (!terms) {
        print_remark("interrupted: nothing was printed");
        return interrupted;
    }
    if (terms->coverage == 0.0f) print_remark("no surface covers this pixel: it shows the background");
    if (command.json)
        write_json(
            as_json(command, open, *terms).dump(2, ' ', false, ordered_json::error_handler_t::replace));
    else
        print(command, open, *terms);
    return done;
}

} // namespace

void add_probe_command(CLI::App& app) {
    const auto options = std::make_shared<ProbeCommand>();
    CLI::App* command = app.add_subcommand("probe", "print the equation at one pixel, term by term");
    command->add_option("SCENE", options->rendering.scene, "a .gltf or .glb file")->required();
    declare(*command, settings::by_probe, options->rendering);
    command
        ->add_option_function<std::string>(
            "--pixel",
            [options](const std::string& text) {
                const auto place = parse_place(text);
                if (!place)
                    throw CLI::ValidationError("--pixel", "'" + text + "' is not X,Y, such as 640,360");
                options->pixel = *place;
            },
            "column and row, counted from the upper left corner, from 0")
        ->type_name("X,Y")
        ->required();
    command->add_flag("--json", options->json, "print JSON");
    command->footer(
        "The rows add up to the pixel that render writes with the same options. wi, cosθ and f_r are means,\n"
        "weighted by what arrives; x, n and wo are those of the pixel's centre.\n\n"
        "Examples:\n"
        "  steradian probe scene.glb --pixel 640,360\n"
        "  steradian probe scene.glb --pixel 10,20 --size 64x64 --samples 256 --json | jq .lights");
    command->callback([options] {
        const ExitStatus status = probe(*options);
        if (status != done) throw CLI::RuntimeError(status);
    });
}

} // namespace sr::cli
