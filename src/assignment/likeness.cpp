#include "assignment/likeness.hpp"

#include "assignment/submission.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/markup.hpp"
#include "golden/process.hpp"
#include "image/whole_file.hpp"

#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>

namespace sr::assignment {
namespace {

using nlohmann::ordered_json;

namespace fs = std::filesystem;

constexpr int not_installed = 77;

/// Prints a JSON line for each pair. 12 and 4: the shortest common stretch that is found for certain has 15
/// signs once each name is one sign (Schleimer, Wilkerson and Aiken 2003, section 3.2), about half a line.
constexpr const char* script = R"(import json, sys
try:
    from copydetect import CodeFingerprint, compare_files
except ImportError:
    sys.exit(77)
folder, count, least = sys.argv[1], int(sys.argv[2]), float(sys.argv[3])
template = CodeFingerprint(f"{folder}/template.glsl", 12, 1, language="glsl")
codes = [CodeFingerprint(f"{folder}/{i}.glsl", 12, 4, list(template.hashes), language="glsl") for i in range(count)]
def stretches(code, slices):
    size = lambda end: len(code.raw_code[:int(end)].encode())
    return [[size(begin), size(end)] for begin, end in zip(*slices)] if len(slices) else []
for a in range(count):
    for b in range(a):
        _, shares, slices = compare_files(codes[b], codes[a])
        if max(shares) >= least:
            print(json.dumps({"a": b, "b": a, "shares": [float(share) for share in shares],
                              "common": [stretches(codes[b], slices[0]), stretches(codes[a], slices[1])]}))
)";

/// The code of all regions, in the order of the tasks.
std::string text_of_regions(const Assignment& assignment, const Submission& submission) {
    std::string text;
    const auto add = [&](const std::string& region) {
        const auto code = submission.codes.find(region);
        if (code == submission.codes.end()) return;
        text += fmt::format("// {}\n{}", region, code->second.text);
        if (!text.ends_with('\n')) text += "\n";
    };
    add(std::string(helpers_region));
    for (const Task& task : assignment.tasks) add(task.id);
    return text;
}

void read_codes(const Assignment& assignment, const ClassFolder& folder, Likeness& likeness) {
    for (const HandedIn& submission : folder.submissions) try {
            std::string text =
                text_of_regions(assignment, read_submission(assignment, SubmittedFiles(submission.path)));
            if (text.empty())
                likeness.remarks.push_back(submission.key + ": has none of the assignment's code");
            else
                likeness.codes.push_back({submission.key, submission.name, std::move(text)});
        } catch (const Error& error) {
            likeness.remarks.push_back(fmt::format("{}: {}", submission.key, error.what()));
        }
}

/// Stretches in order, none beyond the text, those that overlap made one.
std::vector<Stretch> joined(std::vector<Stretch> stretches, std::size_t size) {
    std::ranges::sort(stretches);
    std::vector<Stretch> result;
    for (auto [begin, end] : stretches) {
        end = std::min(end, size);
        if (begin >= end) continue;
        if (!result.empty() && begin <= result.back().second)
            result.back().second = std::max(result.back().second, end);
        else
            result.emplace_back(begin, end);
    }
    return result;
}

void add_pairs(Likeness& likeness, const fs::path& file, std::size_t max_pairs) {
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);) {
        const auto json = ordered_json::parse(line, nullptr, false);
        if (json.is_discarded() || !json.contains("shares")) continue; // a warning of the package
        AlikePair pair{json["a"], json["b"], json["shares"][0], json["shares"][1], {}, {}};
        pair.common_a = joined(json["common"][0], likeness.codes.at(pair.a).text.size());
        pair.common_b = joined(json["common"][1], likeness.codes.at(pair.b).text.size());
        likeness.pairs.push_back(std::move(pair));
    }
    std::ranges::stable_sort(likeness.pairs, std::greater(),
                             [](const AlikePair& pair) { return std::max(pair.share_a, pair.share_b); });
    if (likeness.pairs.size() <= max_pairs) return;
    likeness.remarks.push_back(fmt::format("{} further pairs are above {:.0f} %",
                                           likeness.pairs.size() - max_pairs, 100.0 * likeness.least));
    likeness.pairs.resize(max_pairs);
}

/// The code, with what both have marked.
std::string marked_code(const std::string& text, const std::vector<Stretch>& common) {
    std::string markup;
    std::size_t at = 0;
    for (const auto& [begin, end] : common) {
        markup += escape_markup(text.substr(at, begin - at)) + "<mark>"
                  + escape_markup(text.substr(begin, end - begin)) + "</mark>";
        at = end;
    }
    return markup + escape_markup(text.substr(at));
}

std::string title_of(const ComparedCode& code) {
    return escape_markup(code.name.empty() || code.name == code.key ? code.key
                                                                    : code.name + " (" + code.key + ")");
}

constexpr const char* pairs_style =
    "body { font: 15px/1.45 system-ui, sans-serif; margin: 24px; color-scheme: light dark; }\n"
    "table { border-collapse: collapse; margin: 8px 0 28px; }\n"
    "th, td { padding: 3px 12px 3px 0; text-align: left; border-bottom: 1px solid #8884; }\n"
    ".pair { display: grid; grid-template-columns: 1fr 1fr; gap: 0 16px; }\n"
    "pre { font-size: 12px; line-height: 1.35; white-space: pre-wrap; overflow-wrap: anywhere; margin: 4px "
    "0; }\n"
    "mark { background: #ffe08a; color: #111; }\n"
    "@media (max-width: 700px) { .pair { grid-template-columns: 1fr; } }\n";

} // namespace

std::optional<Likeness> likeness_of(const Assignment& assignment, const LikenessOptions& options) {
    Likeness likeness{assignment.id, options.least, {}, {}, {}};
    const ClassFolder folder = class_folder(options.submissions);
    likeness.remarks = folder.remarks;
    read_codes(assignment, folder, likeness);
    const ScratchFolder scratch("likeness");
    image::write_text(scratch.path() / "template.glsl",
                      text_of_regions(assignment, empty_submission(assignment)));
    for (std::size_t i = 0; i < likeness.codes.size(); ++i)
        image::write_text(scratch.path() / fmt::format("{}.glsl", i), likeness.codes[i].text);
    const fs::path log = scratch.path() / "log";
    // Fingerprints are hashes of Python, which differ from run to run unless this is set.
    const std::vector<std::string> words{"env",
                                         "PYTHONHASHSEED=0",
                                         options.python,
                                         "-c",
                                         script,
                                         scratch.path().string(),
                                         std::to_string(likeness.codes.size()),
                                         fmt::format("{}", options.least)};
    const auto end = golden::run_process({words, scratch.path(), log, options.time_limit, options.stop, {}});
    if (options.stop.stop_requested()) return std::nullopt;
    if (end.way == golden::ProcessEnd::Way::exited && (end.status == not_installed || end.status == 127))
        throw Error(
            fmt::format("likeness needs the Python package copydetect, which {} does not have",
                        options.python),
            fmt::format(
                "install it with `{} -m pip install copydetect`, or name another Python with --python",
                options.python));
    if (!end.is_success())
        throw Error("the Python that compares the submissions " + end.text(),
                    "see whether copydetect works by itself");
    add_pairs(likeness, log, options.max_pairs);
    return likeness;
}

std::string likeness_html(const Likeness& likeness) {
    std::string rows, pairs, remarks;
    const auto percent = [](double share) { return fmt::format("{:.0f} %", 100.0 * share); };
    for (std::size_t i = 0; i < likeness.pairs.size(); ++i) {
        const AlikePair& pair = likeness.pairs[i];
        const ComparedCode &a = likeness.codes[pair.a], &b = likeness.codes[pair.b];
        rows += fmt::format("<tr><td><a href=\"#{}\">look at</a><td>{}<td>{}<td>{}<td>{}\n", i + 1,
                            title_of(a), percent(pair.share_a), title_of(b), percent(pair.share_b));
        pairs += fmt::format(
            "<h2 id=\"{0}\">{0}. alike: {1} and {2}</h2>\n<div class=\"pair\">\n<h3>{1}: {3} is in the "
            "other</h3><h3>{2}: {4}</h3>\n<pre>{5}</pre><pre>{6}</pre>\n</div>\n",
            i + 1, title_of(a), title_of(b), percent(pair.share_a), percent(pair.share_b),
            marked_code(a.text, pair.common_a), marked_code(b.text, pair.common_b));
    }
    for (const std::string& remark : likeness.remarks) remarks += "<p>" + escape_markup(remark) + "</p>\n";
    return fmt::format(
        "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
        "'unsafe-inline'\">\n"
        "<meta name=\"viewport\" content=\"width=device-width\">\n<title>{0}: submissions that are "
        "alike</title>\n"
        "<style>\n{1}</style>\n<h1>{0}: {2} pairs of {3} submissions to look at</h1>\n"
        "<p>A share says how much of one code is in the other, without the template, whatever the names of "
        "variables. "
        "Short functions with one good solution are alike by nature. Compare what is marked, and ask.</p>\n"
        "<table>\n<tr><th><th>submission<th>share<th>submission<th>share\n{4}</table>\n{5}{6}",
        escape_markup(likeness.assignment), pairs_style, likeness.pairs.size(), likeness.codes.size(), rows,
        pairs, remarks);
}

} // namespace sr::assignment
