#include "brdf/laws.hpp"
#include "brdf/parameters.hpp"
#include "brdf/pictures.hpp"
#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "core/output.hpp"
#include "gl/context.hpp"
#include "image/display.hpp"
#include "image/file.hpp"
#include "image/whole_file.hpp"
#include "scene/conductor.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <utility>
#include <variant>

namespace sr::cli {
namespace {

using nlohmann::ordered_json;
using scene::Model;

struct BrdfCommand {
    std::string name;
    std::vector<std::string> outputs;
    brdf::BrdfUnderTest tested;
    std::vector<std::function<void(scene::Material&)>> given; // set a parameter each
    bool has_energy_compensation = false;
    std::string metal = "gold";
    int samples = 64;
    gl::Backend backend = gl::Backend::automatic;
    bool json = false;
};

/// Chooses the BRDF by its name and sets the parameters that were given.
void choose(BrdfCommand& command) {
    auto tested = brdf::brdf_named(command.name, command.backend);
    if (!tested)
        throw CLI::ValidationError("NAME", "'" + command.name + "' is not a BRDF: --help lists the names");
    if (command.name == "gltf") command.name = scene::name_of(Model::metallic_roughness);
    if (tested->material.model == Model::conductor) brdf::set_metal(*tested, command.metal);
    for (const auto& set : command.given) set(tested->material);
    tested->has_energy_compensation = command.has_energy_compensation;
    command.tested = *std::move(tested);
}

/// f_r at the middle of each of a MERL file's cells.
std::vector<vec3> tabulated(brdf::BrdfEvaluator& evaluator) {
    std::vector<brdf::DirectionPair> pairs;
    pairs.reserve(scene::merl_cells);
    for (std::size_t i = 0; i < scene::merl_cells; ++i) {
        const auto [wi, wo] = scene::merl_directions(i);
        pairs.push_back({wi, wo});
    }
    return evaluator.evaluate(pairs);
}

void write_outputs(const BrdfCommand& command, brdf::BrdfEvaluator& evaluator) {
    image::WholeFiles files;
    for (const std::string& output : command.outputs) {
        if (output.ends_with(".svg")) {
            const std::string svg = brdf::draw_polar_plot(evaluator, command.name);
            files.add(output, std::span(reinterpret_cast<const std::uint8_t*>(svg.data()), svg.size()));
        } else if (output.ends_with(".binary")) {
            const std::vector<std::byte> file = scene::merl_file(tabulated(evaluator));
            files.add(output, std::span(reinterpret_cast<const std::uint8_t*>(file.data()), file.size()));
        } else {
            const image::Image film = brdf::render_sphere(command.tested, 256, command.samples);
            const bool is_linear = image::is_scene_referred(output);
            files.add(is_linear ? film : image::displayed(film, image::auto_ev100(film)), output,
                      is_linear ? image::SampleType::floating : image::SampleType::integer8);
        }
    }
    files.put_in_place();
}

/// Reports outputs that cannot be written before anything is computed.
void check_outputs(const BrdfCommand& command) {
    for (const std::string& output : command.outputs) {
        if (!output.ends_with(".svg") && !output.ends_with(".binary")) image::is_scene_referred(output);
        image::require_writable(output);
    }
}

ordered_json albedos_json(brdf::BrdfEvaluator& evaluator) {
    ordered_json list = ordered_json::array();
    const std::vector<vec3> wo = brdf::viewing_directions();
    const std::vector<glm::dvec3> albedos = evaluator.albedos(wo, 8192);
    for (std::size_t i = 0; i < wo.size(); ++i)
        list.push_back({{"cos_o", wo[i].z}, {"albedo", {albedos[i].x, albedos[i].y, albedos[i].z}}});
    return list;
}

ordered_json laws_json(const std::vector<brdf::Law>& laws) {
    ordered_json list = ordered_json::array();
    for (const brdf::Law& law : laws)
        list.push_back({{"law", law.name},
                        {"holds", law.holds()},
                        {"worst", law.worst},
                        {"limit", law.limit},
                        {"where", law.where},
                        {"broken_by_definition", law.is_waived}});
    return list;
}

void print(const ordered_json& json) {
    print_data("{}\n\n", json["brdf"].get<std::string>());
    const char* head = "albedo";
    for (const auto& row : json["albedo"])
        print_data("  {:<6}    cosθ {:.3g}: {:.4f} {:.4f} {:.4f}\n", std::exchange(head, ""),
                   row["cos_o"].get<double>(), row["albedo"][0].get<double>(), row["albedo"][1].get<double>(),
                   row["albedo"][2].get<double>());
    print_data("\n");
    for (const auto& law : json["laws"]) {
        const char* verdict = law["holds"] ? "holds" : law["broken_by_definition"] ? "waived" : "BROKEN";
        print_data("  {:<14} {:<7} {:>11.4g}, limit {:g}, at {}\n", law["law"].get<std::string>(), verdict,
                   law["worst"].is_number() ? law["worst"].get<double>() : INFINITY,
                   law["limit"].get<double>(), law["where"].get<std::string>());
    }
}

ExitStatus look_at(BrdfCommand& command) {
    choose(command);
    check_outputs(command);
    const auto context = gl::open_context({command.backend, false});
    if (command.tested.is_delta()) {
        print_remark("{}: a delta has no values to check: it reflects its base colour from one direction",
                     command.name);
        brdf::BrdfEvaluator evaluator(command.tested);
        write_outputs(command, evaluator);
        return done;
    }
    brdf::BrdfEvaluator evaluator(command.tested);
    const std::vector<brdf::Law> laws = brdf::check_laws(evaluator);
    const ordered_json json{
        {"brdf", command.name}, {"albedo", albedos_json(evaluator)}, {"laws", laws_json(laws)}};
    write_outputs(command, evaluator);
    context->require_silence();
    if (command.json)
        write_json(json.dump(2, ' ', false, ordered_json::error_handler_t::replace));
    else
        print(json);
    if (!command.tested.has_sampling())
        print_remark("{}: the sampling is not checked: the shader declares none", command.name);
    const bool is_lawful =
        std::ranges::all_of(laws, [](const brdf::Law& law) { return law.holds() || law.is_waived; });
    return is_lawful ? done : failed_check;
}

/// The parameters that hold unless they are given.
const scene::Material& default_material() {
    static const scene::Material material = brdf::brdf_named("gltf", gl::Backend::automatic)->material;
    return material;
}

std::string number_text(float value) { return fmt::format("{:g}", value); }

/// Declares a parameter; the command keeps what is given.
void declare_parameter(CLI::App& command, BrdfCommand& o, const brdf::TestedParameter& parameter) {
    const std::string flag = settings::flag_of(parameter.key);
    const scene::Material& defaults = default_material();
    if (const auto* number = std::get_if<float scene::Material::*>(&parameter.member)) {
        CLI::Option* option = command.add_option_function<float>(
            flag,
            [&o, member = *number](float value) {
                o.given.push_back([=](scene::Material& m) { m.*member = value; });
            },
            parameter.help);
        option->check(refusal_of_number);
        if (parameter.max < std::numeric_limits<float>::max())
            option->check(CLI::Range(parameter.min, parameter.max));
        else if (parameter.min == 0.0f)
            option->check(CLI::NonNegativeNumber);
        if (parameter.has_default) option->default_str(number_text(defaults.*(*number)));
        return;
    }
    const auto color = [&](const scene::Material& m) {
        const auto* rgb = std::get_if<vec3 scene::Material::*>(&parameter.member);
        return rgb ? m.*(*rgb) : vec3(m.*std::get<vec4 scene::Material::*>(parameter.member));
    };
    command
        .add_option_function<std::string>(
            flag,
            [&o, flag, member = parameter.member](const std::string& text) {
                const auto value = settings::parse_color(text);
                if (!value) throw CLI::ValidationError(flag, "'" + text + "' is not R,G,B or a number");
                o.given.push_back([member, rgb = *value](scene::Material& m) { brdf::set(m, member, rgb); });
            },
            fmt::format("{} (default: {:g})", parameter.help, color(defaults).x))
        ->type_name("R,G,B");
}

void declare_parameters(CLI::App& command, BrdfCommand& o) {
    for (const brdf::TestedParameter& parameter : brdf::parameters())
        declare_parameter(command, o, parameter);
    std::vector<std::string> metals;
    for (const std::string_view name : scene::metal_names()) metals.emplace_back(name);
    command.add_option("--metal", o.metal, "of conductor")
        ->check(CLI::IsMember(metals))
        ->capture_default_str();
    command.add_flag("--energy-compensation", o.has_energy_compensation,
                     "compensate gltf, ggx and conductor for energy lost to multiple scattering");
}

} // namespace

void add_brdf_command(CLI::App& app) {
    const auto options = std::make_shared<BrdfCommand>();
    CLI::App* command = app.add_subcommand(
        "brdf", "plot one BRDF and check its laws: lobe, albedo, reciprocity, energy, sampling");
    command
        ->add_option("NAME", options->name,
                     fmt::format("{}", fmt::join(brdf::builtin_names(), ", "))
                         + "; a .glsl file that declares f_r; a .binary file of the MERL database")
        ->required();
    command
        ->add_option(
            "-o,--output", options->outputs,
            ".svg: the lobe for four views; .png, .jpg, .exr, .hdr: a lit ball; .binary: the BRDF as a "
            "MERL file (repeatable)")
        ->allow_extra_args(false);
    declare_parameters(*command, *options);
    command->add_option("--samples", options->samples, "of the lit ball's pixels")
        ->check(CLI::Range(1, 65536))
        ->capture_default_str();
    command->add_flag("--json", options->json, "print JSON");
    command->footer(
        "Laws: reciprocity (f_r stays the same when wi and wo change places), negativity (f_r >= 0), energy\n"
        "(no view gets back more than arrives). Laws of the sampling: normalisation (the density\n"
        "integrates to 1), χ² (the samples follow the density). Exit status 1 if a law is broken.\n\n"
        "Examples:\n"
        "  steradian brdf ggx --roughness 0.3 -o lobe.svg -o ball.png\n"
        "  steradian brdf gltf --metallic 1 --anisotropy 0.8 --roughness 0.2 --json\n"
        "  steradian brdf conductor --metal copper --roughness 0.4 -o ball.png\n"
        "  steradian brdf my_brdf.glsl -o lobe.svg          GLSL that declares "
        "vec3 f_r(Surface x, vec3 wi, vec3 wo)\n"
        "  steradian brdf gold-paint.binary -o ball.png     a measured one");
    command->callback([options] {
        const ExitStatus status = look_at(*options);
        if (status != done) throw CLI::RuntimeError(status);
    });
}

} // namespace sr::cli
