#include "brdf/laws.hpp"
#include "brdf/pictures.hpp"
#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "core/file.hpp"
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
    std::string metal = "gold";
    int samples = 64;
    gl::Backend backend = gl::Backend::automatic;
    bool json = false;
};

/// Chooses the BRDF by its name: a built-in one, a GLSL file or a measured one.
void choose(BrdfCommand& command) {
    brdf::BrdfUnderTest& tested = command.tested;
    const auto ends_in = [&](std::string_view suffix) { return command.name.ends_with(suffix); };
    if (command.name == "gltf") command.name = "metallic_roughness";
    if (ends_in(".glsl") || ends_in(".frag")) {
        tested.user = brdf::read_user_shader(command.name);
        tested.trial = std::make_shared<gl::TrialCompiler>(command.backend);
    } else if (ends_in(".binary")) {
        tested.material.model = Model::merl;
        tested.material.measured = 0;
        const std::vector<std::uint8_t> bytes = read_file(command.name, command.name);
        tested.measured.push_back(scene::read_merl(std::as_bytes(std::span(bytes)), command.name));
    } else if (const auto model = scene::model_named(command.name); model && *model != Model::merl) {
        tested.material.model = *model;
    } else {
        throw CLI::ValidationError("NAME", "'" + command.name + "' is not a BRDF: --help lists the names");
    }
    if (tested.material.model == Model::conductor)
        tested.material.conductor = scene::fit_ior(*scene::measured_metal(command.metal));
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

/// "--roughness-across" of "roughness_across".
std::string option_of(const scene::BrdfParameter& parameter) {
    std::string flag = fmt::format("--{}", parameter.key);
    std::ranges::replace(flag, '_', '-');
    return flag;
}

/// The names of the BRDFs that need no file, between commas; glTF's own goes by "gltf".
std::string model_names() {
    std::vector<std::string_view> names{"gltf"};
    for (const scene::BrdfModel& model : std::span(scene::brdf_models).subspan(1))
        if (model.name != scene::name_of(Model::merl)) names.push_back(model.name);
    return fmt::format("{}", fmt::join(names, ", "));
}

void add_color(CLI::App& command, const std::string& name, const std::string& help,
               const std::function<void(vec3)>& take) {
    command
        .add_option_function<std::string>(
            name,
            [name, take](const std::string& text) {
                const auto value = settings::parse_color(text);
                if (!value) throw CLI::ValidationError(name, "'" + text + "' is not R,G,B or a number");
                take(*value);
            },
            help)
        ->type_name("R,G,B");
}

void add_number(CLI::App& command, const char* name, float& value, const CLI::Validator& allowed,
                const char* help) {
    command.add_option(name, value, help)->check(refusal_of_number)->check(allowed)->capture_default_str();
}

/// Declares the parameters of glTF's own BRDF.
void declare_gltf_parameters(CLI::App& command, scene::Material& m) {
    const CLI::Range fraction(0.0f, 1.0f);
    m.base_color = vec4(1.0f);
    m.roughness = 0.5f;
    add_color(command, "--base-color", "ρ; F0 of ggx; tint of conductor and merl (default: 1)",
              [&m](vec3 v) { m.base_color = vec4(v, 1.0f); });
    add_number(command, "--roughness", m.roughness, fraction, "of gltf, ggx, conductor, oren_nayar");
    add_number(command, "--metallic", m.metallic, fraction, "of gltf");
    add_number(command, "--specular", m.specular, fraction, "of gltf: weight of the dielectric's layer");
    add_number(command, "--ior", m.ior, CLI::Range(1.0f, 100.0f), "of gltf");
    add_color(command, "--specular-color",
              "of gltf; of phong, blinn_phong: what their lobe reflects at normal incidence (default: 1)",
              [&m](vec3 v) { m.specular_color = v; });
    add_number(command, "--anisotropy", m.anisotropy, fraction, "of gltf");
    command.add_option("--rotation", m.anisotropy_rotation, "of the anisotropy [rad]")
        ->check(refusal_of_number)
        ->capture_default_str();
    add_number(command, "--clearcoat", m.clearcoat, fraction, "of gltf");
    add_number(command, "--clearcoat-roughness", m.clearcoat_roughness, fraction, "of gltf");
    add_color(command, "--sheen-color", "of gltf (default: 0)", [&m](vec3 v) { m.sheen_color = v; });
    add_number(command, "--sheen-roughness", m.sheen_roughness, fraction, "of gltf");
    add_number(command, "--iridescence", m.iridescence, fraction, "of gltf: weight of a thin film");
    add_number(command, "--film-ior", m.film_ior, CLI::Range(1.0f, 10.0f), "of the thin film");
    add_number(command, "--film-thickness", m.max_film_thickness, CLI::NonNegativeNumber,
               "of the thin film [nm]");
}

/// Declares the parameters of the other models, from the table.
void declare_model_parameters(CLI::App& command, BrdfCommand& o) {
    scene::Material& m = o.tested.material;
    for (const scene::BrdfParameter& parameter : scene::brdf_parameters) {
        const std::string flag = option_of(parameter);
        if (command.get_option_no_throw(flag)) continue; // glTF's own
        const std::string help = fmt::format("of {}: {}", scene::models_with(parameter), parameter.meaning);
        if (const auto* number = std::get_if<float scene::Material::*>(&parameter.member)) {
            CLI::Option* option = command.add_option(flag, m.*(*number), help);
            option->check(refusal_of_number)->check(CLI::Range(parameter.min, parameter.max));
            if (parameter.fallback) option->capture_default_str();
        } else if (const auto* rgb = std::get_if<vec3 scene::Material::*>(&parameter.member)) {
            add_color(command, flag, help + " (default: 1)", [&m, member = *rgb](vec3 v) { m.*member = v; });
        }
    }
    std::vector<std::string> metals;
    for (const std::string_view name : scene::metal_names()) metals.emplace_back(name);
    command.add_option("--metal", o.metal, "of conductor")
        ->check(CLI::IsMember(metals))
        ->capture_default_str();
    command.add_flag("--energy-compensation", o.tested.has_energy_compensation,
                     "compensate gltf, ggx and conductor for energy lost to multiple scattering");
}

} // namespace

void add_brdf_command(CLI::App& app) {
    const auto options = std::make_shared<BrdfCommand>();
    CLI::App* command = app.add_subcommand(
        "brdf", "plot one BRDF and check its laws: lobe, albedo, reciprocity, energy, sampling");
    command
        ->add_option("NAME", options->name,
                     model_names() + "; a .glsl file that declares f_r; a .binary file of the MERL database")
        ->required();
    command
        ->add_option(
            "-o,--output", options->outputs,
            ".svg: the lobe for four views; .png, .jpg, .exr, .hdr: a lit ball; .binary: the BRDF as a "
            "MERL file (repeatable)")
        ->allow_extra_args(false);
    declare_gltf_parameters(*command, options->tested.material);
    declare_model_parameters(*command, *options);
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
