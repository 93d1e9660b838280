#include "viewer/marks.hpp"

#include "assignment/check.hpp"
#include "core/error.hpp"
#include "viewer/palette.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <imgui.h>
#include <nlohmann/json.hpp>
#include <utility>

namespace sr::viewer {
namespace {

using nlohmann::ordered_json;

void put_wrapped(const std::string& text) {
    ImGui::PushTextWrapPos();
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopTextWrapPos();
}

std::string problem_text(const ordered_json& problem) {
    const auto word = [&](const char* key) { return problem[key].get<std::string>(); };
    std::string text;
    if (problem["line"].get<int>() > 0)
        text = fmt::format("{}:{}: ", std::filesystem::path(word("file")).filename().string(),
                           problem["line"].get<int>());
    text += word("text");
    if (!word("source").empty()) text += "\n| " + word("source");
    if (!word("hint").empty()) text += "\n" + word("hint");
    return text;
}

std::string finding_text(const ordered_json& check) {
    const auto word = [&](const char* key) { return check[key].get<std::string>(); };
    std::string text = word("name") + ": " + word("message");
    if (!word("got").empty())
        text += fmt::format("\ngot {}, expected {} {}, at {}", word("got"), word("expected"), word("unit"),
                            word("at"));
    if (!check["diagnosis"].is_null())
        text += fmt::format("\n{}: {}", check["diagnosis"]["name"].get<std::string>(),
                            check["diagnosis"]["text"].get<std::string>());
    const bool repeats = !check["diagnosis"].is_null() && check["diagnosis"]["text"] == check["hint"];
    if (!word("hint").empty() && !repeats) text += "\n" + word("hint");
    return text;
}

TaskMark mark_of(const ordered_json& task) {
    TaskMark mark{task["id"],
                  task["title"],
                  task["status"],
                  task["points"],
                  task["of"],
                  task["extra"],
                  task.value("ended_early", false),
                  {},
                  {}};
    for (const ordered_json& problem : task["problems"]) mark.problems.push_back(problem_text(problem));
    for (const ordered_json& check : task["checks"])
        if (!check["passed"].get<bool>()) mark.findings.push_back(finding_text(check));
    return mark;
}

ImU32 color_of(const TaskMark& task) {
    return task.status == "passed" ? palette::green : task.status.empty() ? palette::grey : palette::orange;
}

} // namespace

Marks::Marks(std::filesystem::path submission, std::filesystem::path program)
    : submission_(std::move(submission)), program_(std::move(program)) {}

Marks::~Marks() {
    if (run_) run_->is_stopped = true; // the future waits for the end
}

void Marks::begin() {
    if (run_) run_->is_stopped = true;
    if (ending_.valid()) ending_.wait();
    run_ = std::make_shared<Run>();
    taken_ = 0;
    has_ended_ = false;
    assignment::CheckOptions options;
    options.program = program_;
    options.is_stopped = [run = run_] { return run->is_stopped.load(); };
    options.on_task = [run = run_](const ordered_json& task) {
        const std::lock_guard lock(run->mutex);
        run->found.push_back(mark_of(task));
    };
    ending_ = std::async(std::launch::async, [submission = submission_, options]() -> std::string {
        try {
            assignment::checked(submission, options);
        } catch (const Error& error) {
            return error.what();
        }
        return {};
    });
}

bool Marks::take() {
    if (!ending_.valid()) return false;
    const bool is_over = ending_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    bool has_new = is_over;
    {
        const std::lock_guard lock(run_->mutex);
        for (; taken_ < run_->found.size(); ++taken_, has_new = true) {
            if (taken_ >= tasks_.size()) tasks_.emplace_back();
            tasks_[taken_] = run_->found[taken_];
        }
    }
    if (is_over) {
        failure_ = ending_.get();
        tasks_.resize(taken_);
        has_ended_ = true;
    }
    return has_new;
}

bool Marks::take_end() { return std::exchange(has_ended_, false); }

std::string Marks::problems() const {
    std::vector<std::string> texts;
    for (const TaskMark& task : tasks_)
        for (const std::string& problem : task.problems)
            if (std::ranges::find(texts, problem) == texts.end()) texts.push_back(problem);
    return in_plain_letters(fmt::format("{}", fmt::join(texts, "\n")));
}

std::string Marks::endless() const {
    const auto found = std::ranges::find_if(tasks_, &TaskMark::is_endless);
    return found == tasks_.end() ? std::string() : found->id;
}

void Marks::draw() const {
    double points = 0.0, of = 0.0;
    for (const TaskMark& task : tasks_) {
        points += task.points;
        if (!task.is_extra) of += task.of;
    }
    ImGui::PushTextWrapPos();
    ImGui::TextUnformatted(
        fmt::format("{:g} of {:g} points{}", points, of, is_checking() ? ", checking ..." : "").c_str());
    for (const TaskMark& task : tasks_) draw_task(task);
    ImGui::TextDisabled("saving a file checks again");
    ImGui::PopTextWrapPos();
}

void Marks::draw_task(const TaskMark& task) const {
    const bool is_empty = task.problems.empty() && task.findings.empty();
    const std::string label =
        in_plain_letters(fmt::format("{} {}  {:g}/{:g}  {}{}###{}", task.id, task.title, task.points, task.of,
                                     task.status, task.is_extra ? " (extra)" : "", task.id));
    ImGui::PushStyleColor(ImGuiCol_Text, color_of(task));
    const bool is_open =
        ImGui::TreeNodeEx(label.c_str(), is_empty ? ImGuiTreeNodeFlags_Leaf : ImGuiTreeNodeFlags_DefaultOpen);
    ImGui::PopStyleColor();
    if (!is_open) return;
    for (const auto* texts : {&task.problems, &task.findings})
        for (const std::string& text : *texts) put_wrapped(in_plain_letters(text));
    ImGui::TreePop();
}

std::string in_plain_letters(std::string text) {
    constexpr std::array<std::pair<const char*, const char*>, 38> spellings{
        {{"α", "alpha"}, {"β", "beta"},   {"γ", "gamma"}, {"δ", "delta"},     {"ε", "epsilon"}, {"η", "eta"},
         {"θ", "theta"}, {"λ", "lambda"}, {"μ", "mu"},    {"ν", "nu"},        {"π", "pi"},      {"ρ", "rho"},
         {"σ", "sigma"}, {"τ", "tau"},    {"φ", "phi"},   {"χ", "chi"},       {"ω", "omega"},   {"Σ", "sum "},
         {"∑", "sum "},  {"Φ", "Phi"},    {"Ω", "Omega"}, {"∫", "integral "}, {"√", "sqrt"},    {"≤", "<="},
         {"≥", ">="},    {"≠", "!="},     {"≈", "~"},     {"∞", "infinity"},  {"−", "-"},       {"⁻", "^-"},
         {"⁴", "^4"},    {"⁵", "^5"},     {"→", "->"},    {"…", "..."},       {"“", "\""},      {"”", "\""},
         {"’", "'"},     {"–", "-"}}};
    for (const auto& [sign, spelling] : spellings)
        for (std::size_t at = 0; (at = text.find(sign, at)) != std::string::npos;)
            text.replace(at, std::string_view(sign).size(), spelling);
    return text;
}

} // namespace sr::viewer
