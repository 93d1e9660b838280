// The mutants as a list, as files and as verdicts, for tools/golden/others.py.
#include "compare/align.hpp"
#include "compare/planes.hpp"
#include "core/error.hpp"
#include "golden_mutants/flip_trials.hpp"
#include "golden_mutants/recipes.hpp"
#include "image/file.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <unistd.h>

namespace {

using sr::testing::Mutant;

struct Arguments {
    std::vector<std::string> sizes;
    std::string folder; // empty: no files
    bool judges = false;
    bool diagnoses = false;
    int flip_seeds = 0; // of harmless pictures, instead of the mutants
    std::vector<std::string> bases;
    std::vector<std::string> only;
};

/// R, G and B, finite; grey becomes R, G and B.
sr::image::Image colors_of(const sr::image::Image& image) {
    std::vector<int> channels;
    for (const std::size_t channel : sr::compare::color_channels(image))
        channels.push_back(static_cast<int>(channel));
    sr::image::Image colors = sr::compare::extract(image, channels);
    for (float& value : colors.pixels)
        if (!std::isfinite(value)) value = 0.0f;
    return colors;
}

bool is_light(const Mutant& mutant) {
    return mutant.options.encoding == sr::compare::Encoding::scene_referred;
}

/// R, G and B of each pixel, floats as they lie in memory.
void write_plain(const sr::image::Image& colors, const std::filesystem::path& file) {
    std::ofstream out(file, std::ios::binary);
    out.write(reinterpret_cast<const char*>(colors.pixels.data()),
              static_cast<std::streamsize>(colors.pixels.size() * sizeof(float)));
    if (!out) throw sr::Error({file.string()}, "cannot be written", "choose another folder");
}

/// Light as .exr, and as a screen shows it as .png; codes of 8 bits as .png alone; and plain numbers.
void write_files(const Mutant& mutant, const std::filesystem::path& folder, const std::string& name) {
    const auto write = [&](const sr::image::Image& image, const char* role) {
        sr::image::write(image, folder / (name + role), sr::image::SampleType::floating);
    };
    if (is_light(mutant) || mutant.options.bits > 8) {
        write(mutant.test, ".test.exr");
        write(mutant.reference, ".reference.exr");
    }
    const auto test = colors_of(mutant.test), reference = colors_of(mutant.reference);
    write_plain(test, folder / (name + ".test.rgb"));
    write_plain(reference, folder / (name + ".reference.rgb"));
    const auto shown =
        sr::compare::display(test, reference, is_light(mutant)); // each at the reference's exposure
    sr::image::write(shown.test, folder / (name + ".test.png"), sr::image::SampleType::integer8);
    sr::image::write(shown.reference, folder / (name + ".reference.png"), sr::image::SampleType::integer8);
}

nlohmann::ordered_json row_of(const Mutant& mutant, const std::string& name, const Arguments& arguments) {
    const auto file_of = [](const sr::image::Image& image) {
        return nlohmann::ordered_json{
            {"width", image.width}, {"height", image.height}, {"channels", image.channel_names}};
    };
    nlohmann::ordered_json row{{"name", name},
                               {"passes", mutant.passes},
                               {"are_codes", !is_light(mutant)},
                               {"test", file_of(mutant.test)},
                               {"reference", file_of(mutant.reference)}};
    if (!arguments.judges) return row;
    sr::compare::CompareOptions options = mutant.options;
    options.measures_appearance = false;
    options.diagnoses = arguments.diagnoses;
    const auto comparison = sr::compare::compare(mutant.test, mutant.reference, options);
    std::string why;
    for (const auto& verdict : comparison.verdicts)
        if (!verdict.passed && why.empty()) why = verdict.line;
    row["steradian"] = comparison.passed;
    row["why"] = why;
    if (!arguments.diagnoses) return row;
    row["wanted_diagnosis"] = mutant.diagnosis;
    row["diagnosis"] = comparison.diagnosis ? comparison.diagnosis->name : "";
    row["layer"] = comparison.diagnosis ? comparison.diagnosis->layer : "";
    row["residual"] = comparison.diagnosis ? comparison.diagnosis->residual : 1.0;
    return row;
}

sr::testing::Extent extent_of(const std::string& text) {
    sr::testing::Extent size;
    char rest = 0;
    if (std::sscanf(text.c_str(), "%dx%d%c", &size.width, &size.height, &rest) != 2 || size.width < 224
        || size.height < 176 || size.width > 8192 || size.height > 8192)
        throw sr::Error("no size of the bases: " + text, "write WIDTHxHEIGHT, from 224x176 to 8192x8192");
    return size;
}

void run_flip_trials(const Arguments& arguments) {
    nlohmann::ordered_json sizes;
    for (const std::string& size : arguments.sizes)
        sizes[size] = sr::testing::flip_trials(extent_of(size), arguments.flip_seeds);
    std::printf("%s\n", sizes.dump(1).c_str());
}

void run(const Arguments& arguments) {
    if (!arguments.folder.empty()) std::filesystem::create_directories(arguments.folder);
    const std::set<std::string> only(arguments.only.begin(), arguments.only.end());
    const std::set<std::string> bases(arguments.bases.begin(), arguments.bases.end());
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    const bool shows_progress = isatty(STDERR_FILENO) != 0;
    const auto is_chosen = [&](const std::string& name) { return only.empty() || only.contains(name); };
    const auto add = [&](const Mutant& mutant, const std::string& name) {
        if (!arguments.folder.empty()) write_files(mutant, arguments.folder, name);
        rows.push_back(row_of(mutant, name, arguments));
        if (shows_progress) std::fprintf(stderr, "\r%zu: %s\033[K", rows.size(), name.c_str());
    };
    if (arguments.sizes.empty())
        for (const Mutant& mutant : sr::testing::mutants())
            if (is_chosen(mutant.name)) add(mutant, mutant.name);
    for (const std::string& size : arguments.sizes)
        for (const sr::testing::Recipe& recipe : sr::testing::recipes()) {
            const std::string base = sr::testing::name_of(recipe.base), name = base + "." + recipe.name;
            if ((!bases.empty() && !bases.contains(base)) || !is_chosen(name)) continue;
            if (arguments.judges || !arguments.folder.empty()) {
                const Mutant mutant = sr::testing::made(recipe, extent_of(size));
                if (!mutant.passes && mutant.test.pixels == mutant.reference.pixels)
                    std::fprintf(stderr, "%s.%s: left out, it changes nothing at this size\n", size.c_str(),
                                 name.c_str());
                else
                    add(mutant, size + "." + name);
            } else
                rows.push_back({{"name", name}, {"passes", recipe.passes}});
        }
    if (shows_progress) std::fputs("\r\033[K", stderr);
    std::printf("%s\n", rows.dump(1).c_str());
}

} // namespace

int main(int argc, char** argv) {
    Arguments arguments;
    CLI::App app{"Right and wrong versions of pictures, as a JSON list with the verdict that each must get."};
    app.add_option("sizes", arguments.sizes,
                   "WIDTHxHEIGHT of the three bases; without it, the small picture's mutants");
    app.add_option("--write", arguments.folder, "folder for the pairs of images");
    app.add_flag("--verdicts", arguments.judges, "judge each, and say why it fails");
    app.add_flag("--diagnose", arguments.diagnoses, "name the causes too");
    app.add_option("--base", arguments.bases, "only of these bases")
        ->check(CLI::IsMember({"render", "photo", "interface"}));
    app.add_option("--only", arguments.only, "only these, by name")->delimiter(',');
    app.add_option("--flips", arguments.flip_seeds,
                   "instead: how many pictures fail of which chance moves edge pixels, with so many seeds")
        ->check(CLI::PositiveNumber);
    app.footer("Examples:\n  build/golden_mutants --verdicts --diagnose\n"
               "  build/golden_mutants 1280x720 --base photo --verdicts\n"
               "  build/golden_mutants 256x256 --only render.dead_pixel --write /tmp/mutants\n"
               "  build/golden_mutants 256x256 640x480 --flips 20");
    CLI11_PARSE(app, argc, argv);
    if (arguments.diagnoses) arguments.judges = true;
    try {
        (arguments.flip_seeds > 0 ? run_flip_trials(arguments) : run(arguments));
        return 0;
    } catch (const sr::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 3;
    }
}
