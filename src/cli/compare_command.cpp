#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "compare/compare.hpp"
#include "compare/pictures.hpp"
#include "core/error.hpp"
#include "core/output.hpp"
#include "core/text.hpp"
#include "image/whole_file.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <variant>

namespace sr::cli {
namespace {

struct CompareCommand {
    std::string test;
    std::string reference;
    std::vector<std::string> limits;
    std::string region;
    std::string mask;
    std::vector<std::string> noise;
    std::string encoding;
    std::string exposures;
    std::string other_layers;
    std::string heat_map;
    std::string side_by_side;
    compare::CompareOptions options;
    bool json = false;
};

/// Sets what the numbers are, as --encoding says or as the files hold them.
void set_encoding(compare::CompareOptions& options, const std::string& encoding, const image::Image& test,
                  const image::Image& reference) {
    compare::set_encoding(options, test, reference);
    if (encoding == "linear") options.encoding = compare::Encoding::scene_referred;
    if (encoding == "srgb") options.encoding = compare::Encoding::display_referred;
    if (encoding.empty() && (compare::integer_bits(test) > 0) != (compare::integer_bits(reference) > 0))
        print_remark("one image holds light and the other codes for a screen: their numbers are compared as "
                     "they are (--encoding tells what they are)");
}

std::optional<compare::PixelRegion> parse_region(const std::string& text) {
    compare::PixelRegion region;
    int end = 0;
    const int fields =
        std::sscanf(text.c_str(), "%d,%d,%dx%d%n", &region.x, &region.y, &region.width, &region.height, &end);
    if (fields != 4 || static_cast<std::size_t>(end) != text.size()) return std::nullopt;
    return region;
}

std::optional<compare::Exposures> parse_exposures(const std::string& text) {
    compare::Exposures exposures;
    int end = 0;
    const int fields =
        std::sscanf(text.c_str(), "%lf,%lf,%d%n", &exposures.start, &exposures.stop, &exposures.count, &end);
    const bool is_whole = fields == 3 && static_cast<std::size_t>(end) == text.size();
    if (!is_whole || !std::isfinite(exposures.start) || !std::isfinite(exposures.stop) || exposures.count < 1
        || exposures.count > 64)
        return std::nullopt;
    return exposures;
}

/// The names of a list with commas; none for "none".
std::vector<std::string> names_in(const std::string& text) {
    std::vector<std::string> names;
    std::istringstream stream(text);
    for (std::string name; std::getline(stream, name, ',');)
        if (name != "none") names.push_back(name);
    return names;
}

/// A number for all pixels, or an image file.
image::Image read_noise(const std::string& text) {
    char* end = nullptr;
    const float number = std::strtof(text.c_str(), &end);
    if (text.empty() || *end != '\0') return image::read(text);
    if (!std::isfinite(number) || number < 0.0f)
        throw CLI::ValidationError("--noise", "'" + text + "' is not a number from 0, nor an image");
    image::Image noise(1, 1, 1);
    noise.pixels[0] = number;
    return noise;
}

compare::CompareOptions options_of(const CompareCommand& command) {
    compare::CompareOptions options = command.options;
    if (!command.region.empty()) options.region = parse_region(command.region);
    if (!command.exposures.empty()) options.exposures = parse_exposures(command.exposures);
    if (!command.other_layers.empty()) options.other_layers = names_in(command.other_layers);
    if (!command.mask.empty()) options.mask = image::read(command.mask);
    for (const std::string& noise : command.noise) options.noise.push_back(read_noise(noise));
    options.tolerances = compare::parse_tolerances(command.limits);
    return options;
}

/// Formats a metric; empty if it was not measured.
std::string text_of(const compare::NamedMetric& metric, double value) {
    if (std::isnan(value)) return {};
    return metric.is_share ? fmt::format("{} {:.4g} %", metric.name, 100.0 * value)
                           : fmt::format("{} {:.4g}", metric.name, value);
}

std::string text_of(const compare::NamedMetric& metric, const std::array<double, 3>& values) {
    return fmt::format("{} {:.6g} {:.6g} {:.6g}", metric.name, values[0], values[1], values[2]);
}

void print_metrics(const compare::Metrics& m) {
    if (m.pixels == 0) return;
    constexpr std::size_t max_columns = 100;
    std::string line = fmt::format("pixels {}", m.pixels);
    const char* heading = "numbers";
    for (const compare::NamedMetric& metric : compare::named_metrics) {
        const std::string text =
            std::visit([&](auto member) { return text_of(metric, m.*member); }, metric.member);
        if (text.empty()) continue;
        if (line.size() + text.size() > max_columns) {
            print_data("  {:<7} {},\n", heading, line);
            heading = "";
            line = text;
        } else {
            line += ", " + text;
        }
    }
    print_data("  {:<7} {}\n", heading, line);
}

void print(const compare::Comparison& comparison, const CompareCommand& command) {
    print_data("{} {} against {}\n", comparison.passed ? "PASS" : "FAIL", shown(command.test),
               shown(command.reference));
    for (const compare::Verdict& verdict : comparison.verdicts)
        print_data("  {:<7} {}\n", verdict.passed ? "ok" : "FAIL", shown(verdict.line));
    print_metrics(comparison.metrics);
    if (const auto& diagnosis = comparison.diagnosis)
        print_data("  {:<7} {} ({}; {:.2g} of the difference is left)\n", "cause", diagnosis->statement,
                   diagnosis->name, diagnosis->residual);
    else if (!comparison.passed)
        print_data("  {:<7} no mistake with a name explains the difference\n", "cause");
}

void print_json(const compare::Comparison& comparison, const CompareCommand& command) {
    nlohmann::ordered_json json{{"test", command.test}, {"reference", command.reference}};
    json.update(compare::json_of(comparison));
    write_json(json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

/// Reports outputs that cannot be written before anything is compared.
void check_outputs_of(const CompareCommand& command) {
    for (const std::string& output : {command.heat_map, command.side_by_side})
        if (!output.empty()) {
            image::is_scene_referred(output);
            image::require_writable(output);
        }
}

ExitStatus compare(const CompareCommand& command) {
    check_outputs_of(command);
    const image::Image test = image::read(command.test), reference = image::read(command.reference);
    compare::CompareOptions options = options_of(command);
    set_encoding(options, command.encoding, test, reference);
    const compare::Comparison comparison = compare::compare(test, reference, options);
    image::WholeFiles files;
    if (!command.heat_map.empty())
        files.add(compare::heat_map(comparison), command.heat_map, image::SampleType::integer8);
    if (!command.side_by_side.empty())
        files.add(compare::side_by_side(test, reference, comparison, options), command.side_by_side,
                  image::SampleType::integer8);
    files.put_in_place();
    if (command.json)
        print_json(comparison, command);
    else
        print(comparison, command);
    return comparison.passed ? done : failed_check;
}

/// A check that refuses what `parse` does; CLI11 then says what was expected.
template<typename Parse>
std::function<std::string(const std::string&)> accepted_by(Parse parse, const char* expected) {
    return [=](const std::string& text) {
        return parse(text) ? std::string() : fmt::format("'{}' is not {}", text, expected);
    };
}

std::string refusal_of_limit(const std::string& text) {
    try {
        compare::parse_tolerance(text);
        return {};
    } catch (const Error& error) {
        return error.what();
    }
}

std::string refusal_of_picture(const std::string& file) {
    try {
        return image::is_scene_referred(file) ? "a picture is a .png or .jpg" : "";
    } catch (const Error& error) {
        return error.what();
    }
}

void declare_judgement(CLI::App& command, CompareCommand& o) {
    command.add_option("TEST", o.test, "the image in question, any format")->required();
    command.add_option("REF", o.reference, "the image that is right")->required();
    command
        .add_option("--max,--min", o.limits,
                    "a limit, instead of the default ones (repeatable): rel, abs, z, flip or hdr_flip, with "
                    "@PERCENT% "
                    "of the pixels that must keep it, rel, abs and z also with @edges, which forgives a few "
                    "pixels at "
                    "edges; flip, hdr_flip (means), mean_rel, mean_abs, rmse, rel_mse, "
                    "energy, density; ssim is at least so much")
        ->type_name("NAME=LIMIT[@PERCENT%|@edges]")
        ->allow_extra_args(false)
        ->check(refusal_of_limit);
    command.add_flag("--allow-nonfinite", o.options.allow_nonfinite,
                     "leave NaN and infinite pixels out instead of failing");
    command
        .add_option(
            "--noise", o.noise,
            "standard error of each pixel's mean, as a number or an image: differences are then judged as "
            "z-scores (repeatable, one for TEST and one for REF: their squares add up)")
        ->type_name("NUMBER|FILE")
        ->allow_extra_args(false);
}

void declare_scope(CLI::App& command, CompareCommand& o) {
    command.add_option("--region", o.region, "compare only these pixels, counted from the upper left")
        ->type_name("X,Y,WIDTHxHEIGHT")
        ->check(accepted_by(parse_region, "X,Y,WIDTHxHEIGHT, such as 0,0,64x64"));
    command.add_option("--mask", o.mask, "compare only where this image's first channel exceeds 0.5")
        ->type_name("FILE");
    command
        .add_option("--layer", o.options.layer,
                    "compare only this layer of both files (NAME.R, NAME.G, NAME.B)")
        ->type_name("NAME");
    command
        .add_option(
            "--other-layers", o.other_layers,
            "compare only these layers beside the picture, separated by commas, or none (default: all "
            "of REF)")
        ->type_name("NAME,NAME|none");
    command
        .add_option(
            "--encoding", o.encoding,
            "what the numbers are: linear light or sRGB codes (default: codes if both files hold integers)")
        ->check(CLI::IsMember({"linear", "srgb"}));
    command
        .add_option("--exposures", o.exposures, "of HDR-FLIP, in stops (default: from what is lit in REF)")
        ->type_name("START,STOP,COUNT")
        ->check(accepted_by(parse_exposures, "START,STOP,COUNT, such as -2,6,9 (at most 64)"));
    command.add_option("--pixels-per-degree", o.options.pixels_per_degree, "of the screen, for FLIP")
        ->check(refusal_of_number)
        ->check(CLI::Range(1.0f, 1000.0f))
        ->capture_default_str();
}

} // namespace

void add_compare_command(CLI::App& app) {
    const auto o = std::make_shared<CompareCommand>();
    CLI::App* command =
        app.add_subcommand("compare", "compare two images, and say by how much and why they differ");
    declare_judgement(*command, *o);
    declare_scope(*command, *o);
    command->add_option("--heat-map", o->heat_map, "write each pixel's error over its limit as colours")
        ->type_name("OUT.png")
        ->check(refusal_of_picture);
    command->add_option("--side-by-side", o->side_by_side, "write test, reference and heat map side by side")
        ->type_name("OUT.png")
        ->check(refusal_of_picture);
    command->add_flag("--json", o->json, "print JSON");
    command->footer(
        "Default limits: of light rel=0.01@edges and energy=0.005, of codes for a screen abs=0.0079@edges\n"
        "(of 16 bits 0.001) and energy=0.01, with --noise z=auto@edges. Where a share of the pixels may "
        "fail,\n"
        "density=0.25 is added. Alpha and all layers of REF are compared, too; with --noise by "
        "their own noise where FILE has it, else by the default limits.\n\n"
        "Examples:\n"
        "  steradian compare test.exr golden.exr\n"
        "  steradian compare test.exr golden.exr --max rel=0.02@99.5% --max flip=0.03 --heat-map heat.png\n"
        "  steradian compare mine.exr truth.exr --noise truth_stderr.exr --region 0,0,64x64\n"
        "  steradian compare screenshot.png golden.png --min ssim=0.99 --side-by-side both.png\n"
        "  steradian compare test.exr golden.exr --json | jq .diagnosis\n\n"
        "Exit status: 0 they agree, 1 they differ, 2 usage, 3 a file is at fault.");
    command->callback([o] {
        const ExitStatus status = compare(*o);
        if (status != done) throw CLI::RuntimeError(status);
    });
}

} // namespace sr::cli
