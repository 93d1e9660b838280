#include "assignment/tick.hpp"

#include "assignment/questions.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "glsl/untrusted.hpp"
#include "golden/process.hpp"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

namespace sr::assignment {
namespace {

using nlohmann::ordered_json;

namespace fs = std::filesystem;

constexpr std::size_t max_code_lines = 14; // of code on the sheet
constexpr std::size_t max_excerpt = 160;   // bytes of a line there

void write_json_line(std::ostream& stream, const ordered_json& json) {
    stream << json.dump(-1, ' ', false, ordered_json::error_handler_t::replace) << std::endl;
}

/// Names, numbers and signs of a line.
std::multiset<std::string> tokens_of(const std::string& line) {
    std::multiset<std::string> tokens;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const auto is_word = [&](std::size_t at) {
            return at < line.size()
                   && (std::isalnum(static_cast<unsigned char>(line[at])) || line[at] == '_');
        };
        std::size_t end = i + 1;
        while (is_word(i) && is_word(end)) ++end;
        if (!std::isspace(static_cast<unsigned char>(line[i]))) tokens.insert(line.substr(i, end - i));
        i = end - 1;
    }
    return tokens;
}

std::vector<std::multiset<std::string>> tokens_of_lines(const std::string& text) {
    std::vector<std::multiset<std::string>> result;
    std::istringstream lines(without_comments(text));
    for (std::string line; std::getline(lines, line);) result.push_back(tokens_of(line));
    return result;
}

struct CodeLine {
    std::string task, file, text;
    int number = 0;
    std::size_t differs = 0; // the tokens that no line of the template has together with the others
};

/// The lines of a region, each with its distance to the nearest line of the template.
void add_lines(std::vector<CodeLine>& lines, const std::string& region, const Code& code,
               const std::string& template_text) {
    const auto given = tokens_of_lines(template_text);
    const auto own = tokens_of_lines(code.text);
    std::istringstream stream(code.text);
    std::size_t i = 0;
    for (std::string line; std::getline(stream, line) && i < own.size(); ++i) {
        std::size_t common = 0;
        for (const auto& tokens : given) {
            std::vector<std::string> shared;
            std::ranges::set_intersection(own[i], tokens, std::back_inserter(shared));
            common = std::max(common, shared.size());
        }
        lines.push_back({region, fs::path(code.place).filename().string(), line.substr(0, max_excerpt),
                         code.line + static_cast<int>(i), own[i].size() - common});
    }
}

/// The lines that differ most from the template, in their order.
ordered_json code_of(const Assignment& assignment, const Submission& submission) {
    const Submission given = empty_submission(assignment);
    std::vector<CodeLine> lines;
    for (const auto& [region, code] : submission.codes) {
        const auto found = given.codes.find(region);
        add_lines(lines, region, code, found == given.codes.end() ? "" : found->second.text);
    }
    std::vector<std::size_t> distances;
    for (const CodeLine& line : lines) distances.push_back(line.differs);
    std::ranges::sort(distances, std::greater());
    const std::size_t least =
        distances.empty()
            ? 1
            : std::max<std::size_t>(1, distances[std::min(max_code_lines, distances.size()) - 1]);
    ordered_json code = ordered_json::array();
    for (const CodeLine& line : lines)
        if (line.differs >= least && code.size() < max_code_lines)
            code.push_back({{"task", line.task},
                            {"file", line.file},
                            {"line", line.number},
                            {"text", line.text},
                            {"differs", line.differs}});
    return code;
}

std::vector<ordered_json> lines_in(const fs::path& file) {
    std::vector<ordered_json> lines;
    std::error_code ignored;
    if (!fs::is_regular_file(fs::symlink_status(file, ignored))) return lines; // a pipe would block
    std::ifstream stream(file, std::ios::binary);
    for (std::string line; std::getline(stream, line) && !stream.eof();) // a last line may be half there
        if (auto json = ordered_json::parse(line, nullptr, false); !json.is_discarded())
            lines.push_back(std::move(json));
    return lines;
}

/// Adds what a child writes about the tasks to the examination.
void add_questions(ordered_json& examination, const fs::path& submission, const CheckOptions& options,
                   const std::vector<std::string>& tasks, const std::string& seed) {
    const ScratchFolder scratch("tick");
    const fs::path results = scratch.path() / "results"; // the child writes here and nowhere else
    fs::create_directory(results);
    MarkRequest request{fs::absolute(submission), results / "questions.jsonl", tasks, false, options.grading};
    request.tick_seed = seed;
    constexpr int count = 4;
    request.processor_seconds = static_cast<int>(4.0 * count * options.time_limit) + 1;
    std::vector<std::string> words{options.program.string()};
    std::ranges::copy(words_of(request), std::back_inserter(words));
    std::stop_source ending;
    const std::stop_callback ending_with_all(options.stop, [&] { ending.request_stop(); });
    std::uintmax_t size = 0;
    auto since = std::chrono::steady_clock::now();
    const auto end = golden::run_process(
        {words, fs::current_path(), scratch.path() / "log", 3600.0, ending.get_token(), [&] {
             std::error_code ignored;
             const auto now = std::chrono::steady_clock::now();
             const auto found = fs::file_size(request.results, ignored);
             if (!ignored && std::exchange(size, found) != found) since = now;
             if (std::chrono::duration<double>(now - since).count() > options.time_limit)
                 ending.request_stop();
         }});
    for (ordered_json& line : lines_in(request.results)) {
        if (line.contains("code")) examination["code"] = line["code"];
        if (line.contains("question")) examination["questions"].push_back(line["question"]);
        if (line.contains("missing")) examination["missing"].push_back(line["missing"]);
    }
    if (end.is_success()) return;
    examination["missing"].push_back(
        end.way == golden::ProcessEnd::Way::stopped
            ? fmt::format("further questions took longer than {:g} s each and were ended", options.time_limit)
            : "the process that makes the questions " + end.text());
}

} // namespace

void write_questions(const Assignment& assignment, const Submission& submission, const std::string& student,
                     const std::vector<std::string>& tasks, const std::string& seed, std::ostream& stream) {
    write_json_line(stream, {{"code", code_of(assignment, submission)}});
    try {
        Examiner examiner(assignment, submission, student, tasks, seed);
        struct Kind {
            const char* name;
            ordered_json (Examiner::*ask)();
        };
        for (const auto& [name, ask] : {Kind{"a pixel", &Examiner::pixel_question},
                                        {"a parameter", &Examiner::parameter_question},
                                        {"a law", &Examiner::law_question},
                                        {"a replacement", &Examiner::replacement_question}})
            try {
                write_json_line(stream, {{"question", (examiner.*ask)()}});
            } catch (const Error& error) { // LoopError and ShaderError among them
                write_json_line(stream, {{"missing", fmt::format("{}: {}", name, error.what())}});
            }
    } catch (const Error& error) {
        write_json_line(stream, {{"missing", error.what()}});
    }
}

std::optional<ordered_json> examine(const fs::path& submission, const CheckOptions& options,
                                    const std::string& seed) {
    require(options.grading.has_value(), "an examination is confined");
    auto examination = check_submission(submission, options);
    if (!examination) return std::nullopt;
    std::vector<std::string> tasks;
    for (const ordered_json& task : (*examination)["tasks"])
        if (task["status"] == "passed" || task["status"] == "failed") tasks.push_back(task["id"]);
    std::string chosen = seed.empty() ? (*examination)["student"].get<std::string>() : seed;
    if (chosen.empty()) chosen = "none"; // an option of the child needs a value
    (*examination)["seed"] = chosen;
    for (const char* key : {"code", "questions", "missing"}) (*examination)[key] = ordered_json::array();
    if (tasks.empty())
        (*examination)["missing"].push_back("no task of this submission has code that runs");
    else
        add_questions(*examination, submission, options, tasks, chosen);
    if (options.stop.stop_requested()) return std::nullopt;
    return examination;
}

} // namespace sr::assignment
