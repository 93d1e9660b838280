// Assignment tool: marks of a student's folder, which child processes check, and the reference render.
#include "assignment/check.hpp"
#include "core/error.hpp"
#include "core/parallel.hpp"
#include "viewer/document/watch.hpp"
#include "viewer/palette.hpp"
#include "viewer/tools/tool.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <future>
#include <imgui.h>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace sr::viewer {
/// Marks of a task.
struct TaskMark {
    std::string id;
    std::string title;
    std::string status; // assets/assignment_result.schema.json; empty before the check
    double points = 0.0;
    double of = 0.0;
    bool is_extra = false;
    bool is_endless = false;           // its check did not end by itself
    std::vector<std::string> problems; // in the code, each with its line and a hint
    std::vector<std::string> findings; // of failed checks
};

/// Checker of a student's folder, on a thread.
class Checker {
public:
    /// `program`: steradian, which checks in child processes.
    Checker(std::filesystem::path submission, std::filesystem::path program);
    ~Checker();
    Checker(const Checker&) = delete;
    Checker& operator=(const Checker&) = delete;

    /// Begins to check the files. A check that still runs is stopped.
    void begin();
    bool is_checking() const { return ending_.valid(); }

    /// Takes new marks. @return true if there are any, or the check has ended
    bool take();
    /// Tells, once, that a check has ended.
    bool take_end();

    /// Problems in the code, one below the other; empty if it compiles.
    std::string problems() const;
    /// The task whose check did not end by itself; empty if there is none.
    std::string endless_task() const;
    /// The reason why nothing was checked; empty if there was none.
    const std::string& failure() const { return failure_; }

    void draw() const;

private:
    /// State that the thread writes.
    struct Run {
        std::stop_source stop;
        std::mutex mutex;
        std::vector<TaskMark> found;
    };
    void draw_task(const TaskMark& task) const;

    std::filesystem::path submission_;
    std::filesystem::path program_;
    std::shared_ptr<Run> run_;
    std::future<std::string> ending_; // the failure; empty if there was none
    std::vector<TaskMark> tasks_;     // of the last check, which a new check replaces one by one
    std::size_t taken_ = 0;           // of run_->found
    std::string failure_;
    bool has_ended_ = false;
};

class Assignment : public Tool {
public:
    explicit Assignment(Workspace& workspace);

    Changes update(double seconds) override;
    Changes draw(const Overlay& overlay) override;
    FilmSum reference_film() const override;
    Activity activity() const override;

private:
    Changes advance_reference();
    Changes end_check();
    bool needs_reference() const;
    void draw_comparison();

    Checker checker_;
    Watch shader_watch_;
};

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

Checker::Checker(std::filesystem::path submission, std::filesystem::path program)
    : submission_(std::move(submission)), program_(std::move(program)) {}

Checker::~Checker() {
    if (run_) run_->stop.request_stop(); // the future waits for the thread
}

void Checker::begin() {
    if (run_) run_->stop.request_stop();
    if (ending_.valid()) ending_.wait();
    run_ = std::make_shared<Run>();
    taken_ = 0;
    has_ended_ = false;
    assignment::CheckOptions options;
    options.program = program_;
    options.stop = run_->stop.get_token();
    options.on_task = [run = run_](const ordered_json& task) {
        const std::lock_guard lock(run->mutex);
        run->found.push_back(mark_of(task));
    };
    ending_ = started([submission = submission_, options]() -> std::string {
        try {
            assignment::check_submission(submission, options);
        } catch (const Error& error) {
            return error.what();
        }
        return {};
    });
}

bool Checker::take() {
    if (!ending_.valid()) return false;
    const bool is_over = is_done(ending_);
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

bool Checker::take_end() { return std::exchange(has_ended_, false); }

std::string Checker::problems() const {
    std::vector<std::string> texts;
    for (const TaskMark& task : tasks_)
        for (const std::string& problem : task.problems)
            if (std::ranges::find(texts, problem) == texts.end()) texts.push_back(problem);
    return in_plain_letters(fmt::format("{}", fmt::join(texts, "\n")));
}

std::string Checker::endless_task() const {
    const auto found = std::ranges::find_if(tasks_, &TaskMark::is_endless);
    return found == tasks_.end() ? std::string() : found->id;
}

void Checker::draw() const {
    double points = 0.0, of = 0.0;
    for (const TaskMark& task : tasks_) {
        points += task.points;
        if (!task.is_extra) of += task.of;
    }
    ImGui::PushTextWrapPos();
    ImGui::TextUnformatted(
        fmt::format("{:g} of {:g} points{}", points, of, is_checking() ? ", checking ..." : "").c_str());
    for (const TaskMark& task : tasks_) draw_task(task);
    ImGui::TextDisabled("Save a file to check again.");
    ImGui::PopTextWrapPos();
}

void Checker::draw_task(const TaskMark& task) const {
    const bool is_empty = task.problems.empty() && task.findings.empty();
    const std::string label =
        in_plain_letters(fmt::format("{}  {:g}/{:g}  {}{}  {}###{}", task.id, task.points, task.of,
                                     task.status, task.is_extra ? " (extra)" : "", task.title, task.id));
    ImGui::PushStyleColor(ImGuiCol_Text, color_of(task));
    const bool is_open =
        ImGui::TreeNodeEx(label.c_str(), is_empty ? ImGuiTreeNodeFlags_Leaf : ImGuiTreeNodeFlags_DefaultOpen);
    ImGui::PopStyleColor();
    if (!is_open) return;
    for (const auto* texts : {&task.problems, &task.findings})
        for (const std::string& text : *texts) put_wrapped(in_plain_letters(text));
    ImGui::TreePop();
}

Assignment::Assignment(Workspace& workspace)
    : Tool(workspace), checker_(workspace.options.submission, workspace.options.program) {
    shader_watch_.set({ws_.options.shaders.begin(), ws_.options.shaders.end()});
    ws_.options.shows_reference = true;
    checker_.begin();
}

/// True if the reference's render is shown beside the student's. A kept or loaded reference replaces it.
bool Assignment::needs_reference() const {
    const ComparisonMode comparison = ws_.display.comparison;
    return !ws_.kept.reference() && !ws_.is_term_left_out
           && (comparison == ComparisonMode::wipe || comparison == ComparisonMode::difference);
}

Activity Assignment::activity() const {
    const ProgressiveRender* reference = ws_.scene ? ws_.scene->reference() : nullptr;
    if (ws_.scene && needs_reference() && !(reference && reference->is_converged())) return Activity::active;
    return checker_.is_checking() ? Activity::waiting : Activity::idle;
}

FilmSum Assignment::reference_film() const {
    const ProgressiveRender* reference = needs_reference() ? ws_.scene->reference() : nullptr;
    return reference && reference->sample_count() > 0 ? reference->shown() : FilmSum{};
}

Changes Assignment::update(double /*seconds*/) {
    Changes changes;
    if (shader_watch_.has_changed()) checker_.begin();
    if (checker_.take()) changes |= Change::redraw;
    if (checker_.take_end()) changes |= end_check();
    if (needs_reference()) changes |= advance_reference();
    return changes;
}

/// A reference that cannot be rendered is not tried again until a person asks for it.
Changes Assignment::advance_reference() {
    try {
        ws_.scene->advance_reference(ws_.options, ws_.camera->camera(), ws_.width, ws_.height);
        return {};
    } catch (const Error& error) {
        ws_.display.comparison = ComparisonMode::none;
        ws_.messages.fail("The reference cannot be shown. The render stays.", error.what());
        return Change::display;
    }
}

/// Shows the student's code. The window runs it only after the check has ended: an endless loop would hang
/// the window.
Changes Assignment::end_check() {
    if (!checker_.failure().empty()) {
        ws_.messages.fail("Cannot check the assignment.", checker_.failure());
        return Change::redraw;
    }
    if (const std::string task = checker_.endless_task(); !task.empty()) {
        ws_.messages.fail(fmt::format("{} does not end. The render uses the previous code.", task),
                          checker_.problems());
        return Change::redraw;
    }
    ws_.options.shows_reference = false;
    const Changes changes = ws_.reload_shaders();
    if (ws_.messages.has_error() && !checker_.problems().empty())
        ws_.messages.fail("Your code does not compile. The render uses the previous code.",
                          checker_.problems());
    return changes;
}

void Assignment::draw_comparison() {
    const auto choice = [&](const char* label, ComparisonMode comparison, const char* meaning) {
        if (ImGui::RadioButton(label, ws_.display.comparison == comparison))
            ws_.display.comparison = comparison;
        tooltip(meaning);
    };
    choice("yours", ComparisonMode::none, "the picture of your code");
    ImGui::SameLine();
    choice("yours | reference", ComparisonMode::wipe, "yours at the left, the reference at the right");
    ImGui::SameLine();
    choice("difference", ComparisonMode::difference, "blue: darker than the reference; orange: brighter");
    if (ws_.display.comparison != ComparisonMode::wipe) return;
    ImGui::SliderFloat("##wipe", &ws_.display.wipe, 0.0f, 1.0f, "%.2f");
    tooltip("share of the picture's width that shows yours");
}

Changes Assignment::draw(const Overlay& overlay) {
    const PanelPlace place = ws_.layout.take_side(side::assignment);
    if (!place.is_shown) return {};
    const bool is_docked = place.area.has_value();
    if (is_docked) {
        place_next_window(*place.area);
    } else {
        const vec2 window = ws_.window_size();
        const float width = std::min(540.0f * overlay.scale, 0.6f * window.x);
        const float below_errors = 6.0f * ImGui::GetFontSize(); // so that an error of few lines hides no mark
        ImGui::SetNextWindowPos({window.x - width - 10.0f, below_errors}, ImGuiCond_FirstUseEver);
        ImGui::SetNextWindowSizeConstraints({width, 0.0f}, {width, window.y - 2.0f * below_errors});
    }
    if (ImGui::Begin(side::assignment, nullptr, ws_.ui.panel_flags(is_docked))) {
        if (is_docked) heading(side::assignment, ws_.ui);
        if (!ws_.kept.reference())
            draw_comparison(); // the section "Compare" has the modes of a kept reference
        if (ws_.options.shows_reference)
            ImGui::TextDisabled("This is the reference until your code is checked.");
        checker_.draw();
    }
    if (!is_docked) keep_in_viewport();
    ImGui::End();
    return {};
}

std::unique_ptr<Tool> make_assignment(Workspace& workspace) {
    if (workspace.options.submission.empty()) return nullptr;
    return std::make_unique<Assignment>(workspace);
}

} // namespace sr::viewer
