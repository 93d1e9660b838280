// Tick tool: the questions of an oral examination, each shown where it belongs, with answers that a key
// uncovers.
#include "assignment/tick.hpp"
#include "assignment/submission.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/parallel.hpp"
#include "image/whole_file.hpp"
#include "viewer/tools/tool.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <future>
#include <imgui.h>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>
#include <sstream>
#include <string>
#include <utility>

namespace sr::viewer {

using TickQuestion = nlohmann::ordered_json; // of assignment/questions.hpp

class Tick : public Tool {
public:
    explicit Tick(Workspace& workspace);
    ~Tick() override;

    std::optional<Changes> handle(const Event& event) override;
    Changes update(double seconds) override;
    Changes draw(const Overlay& overlay) override;
    Activity activity() const override { return making_.valid() ? Activity::waiting : Activity::idle; }

private:
    Changes go_to_next();
    Changes try_change();
    Changes take_back();
    void hold_exposure();
    Changes apply_to_code(const TickQuestion& facts);
    Changes apply_to_scene(const TickQuestion& facts);
    Changes go_to_pixel(const TickQuestion& facts);
    std::filesystem::path emptied_folder();
    bool is_busy() const;
    void draw_question(const TickQuestion& question);

    std::stop_source stop_;
    std::future<TickQuestion> making_; // the examination
    std::vector<TickQuestion> questions_;
    std::vector<std::string> missing_;
    std::optional<ScratchFolder> scratch_; // changed files; made when first needed
    std::string own_scene_;                // the scene while another one is shown; empty: it is shown
    std::size_t at_ = 0;
    bool shows_answer_ = false;
    bool is_changed_ = false;
    bool holds_exposure_ = false; // which is automatic otherwise
};

namespace {

bool needs_other_scene(const TickQuestion& question) {
    return question["kind"] == "parameter" && !question["facts"]["pointer"].get<std::string>().empty();
}

/// The file with the changed line. @throws Error if the student has changed that line since
std::string with_line(const std::filesystem::path& file, const TickQuestion& line) {
    std::string text = read_text(file);
    std::size_t begin = 0;
    for (int i = 1; i < line["line"].get<int>(); ++i) begin = text.find('\n', begin) + 1;
    const std::string from = line["from"];
    const std::size_t at = text.find(from, begin);
    if (at == std::string::npos || at > text.find('\n', begin))
        throw Error({file.string(), line["line"].get<int>()},
                    "the line has changed since the question was made",
                    "start the window again for new questions");
    text.replace(at, from.size(), line["to"].get<std::string>());
    return text;
}

} // namespace

Tick::Tick(Workspace& workspace) : Tool(workspace) {
    assignment::CheckOptions options;
    options.program = ws_.options.program;
    options.time_limit = 60.0; // it shares the machine with the window
    options.stop = stop_.get_token();
    options.grading.emplace();
    const std::filesystem::path submission = ws_.options.submission;
    options.grading->assignment =
        std::filesystem::absolute(assignment::assignment_of(assignment::label_of(submission)));
    making_ = started([submission, options]() -> TickQuestion {
        try {
            if (auto examination = assignment::examine(submission, options, ""))
                return *std::move(examination);
        } catch (const Error& error) {
            return {{"questions", TickQuestion::array()}, {"missing", {error.what()}}};
        }
        return {{"questions", TickQuestion::array()}, {"missing", TickQuestion::array()}};
    });
}

Tick::~Tick() {
    stop_.request_stop(); // the future waits for the thread
    if (making_.valid()) making_.wait();
}

Changes Tick::update(double /*seconds*/) {
    if (!making_.valid() || !is_done(making_)) return {};
    const TickQuestion examination = making_.get();
    questions_ = examination["questions"].get<std::vector<TickQuestion>>();
    missing_ = examination["missing"].get<std::vector<std::string>>();
    ws_.messages.notify(fmt::format("{} questions. J: next, U: answer, I: try it.", questions_.size()));
    return Change::redraw;
}

std::optional<Changes> Tick::handle(const Event& event) {
    const auto command = command_in(event);
    if (questions_.empty() || !command) return std::nullopt;
    const bool changes = command == Command::next_question || command == Command::try_question;
    if (changes && is_busy()) return Change::redraw;
    try {
        if (command == Command::next_question) ws_.show_panel(side::examination);
        if (command == Command::next_question) return go_to_next();
        if (command == Command::try_question) return is_changed_ ? take_back() : try_change();
    } catch (const Error& error) {
        ws_.messages.fail("The change cannot be shown.", error.what());
        return Change::redraw;
    }
    if (command != Command::show_answer) return std::nullopt;
    shows_answer_ = ws_.show_panel(side::examination) || !shows_answer_;
    ws_.messages.log(shows_answer_ ? "The answer is shown." : "The answer is hidden.");
    return Change::redraw;
}

/// Says why the key can do nothing now: a scene is loading, or another scene would drop unsaved edits.
bool Tick::is_busy() const {
    const bool opens = is_changed_ ? !own_scene_.empty() : needs_other_scene(questions_[at_]);
    if (ws_.loading)
        ws_.messages.notify("A file is loading. Try again when it is done.");
    else if (opens && ws_.scene->lights().is_unsaved())
        ws_.messages.notify(
            fmt::format("The scene has unsaved edits. Save them ({}) or undo them ({}) first.",
                        ws_.keys.text(Command::save_as), ws_.keys.text(Command::undo_light)));
    else
        return false;
    return true;
}

/// The folder of one change. Files of the change before are removed: their lines are not replaced any more.
std::filesystem::path Tick::emptied_folder() {
    if (!scratch_) scratch_.emplace("view-tick");
    const std::filesystem::path folder = scratch_->path() / "change";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    return folder;
}

Changes Tick::go_to_next() {
    const Changes changes = is_changed_ ? take_back() : Changes(Change::redraw);
    at_ = (at_ + 1) % questions_.size();
    shows_answer_ = false;
    ws_.messages.notify(fmt::format("Question {} of {}.", at_ + 1, questions_.size()));
    return changes;
}

/// Goes to the question's pixel, or makes its change.
Changes Tick::try_change() {
    const TickQuestion& question = questions_[at_];
    const TickQuestion& facts = question["facts"];
    if (question["kind"] == "pixel") return go_to_pixel(facts);
    if (question["kind"] == "parameter") return apply_to_scene(facts);
    if (!facts["line"].is_null()) return apply_to_code(facts["line"]);
    ws_.messages.notify("This question has nothing to try.");
    return Change::redraw;
}

Changes Tick::go_to_pixel(const TickQuestion& facts) {
    const TickQuestion& x = facts["terms"]["x"];
    const auto place = ws_.projection()(vec3(x[0].get<float>(), x[1].get<float>(), x[2].get<float>()));
    if (!place)
        ws_.messages.notify("The pixel is out of view. 0 goes back to the file's camera.");
    else
        ws_.wanted_probe = *place;
    return Change::redraw;
}

/// Keeps the exposure while a change is shown: an automatic one would hide that a picture became brighter.
void Tick::hold_exposure() {
    is_changed_ = true;
    if (!ws_.exposure.is_automatic()) return;
    ws_.exposure.fix(ws_.exposure.ev100());
    holds_exposure_ = true;
}

/// Shows the scene by the student's code with a line replaced, or another parameter.
Changes Tick::apply_to_code(const TickQuestion& line) {
    const std::filesystem::path folder = emptied_folder();
    const std::string file = line["file"];
    image::write_text(folder / file, with_line(std::filesystem::path(ws_.options.submission) / file, line));
    ws_.options.changed_code = folder.string();
    ws_.options.shaders.insert(ws_.options.shaders.begin(), folder.string());
    hold_exposure();
    const Changes changes = ws_.reload_shaders();
    ws_.messages.notify(fmt::format("{}:{} is replaced. I takes it back.", file, line["line"].get<int>()));
    return changes;
}

Changes Tick::apply_to_scene(const TickQuestion& facts) {
    const std::string pointer = facts["pointer"];
    if (pointer.empty()) {
        const std::filesystem::path file = std::filesystem::path(ws_.options.submission) / "parameters.glsl";
        const std::regex form("\\b" + facts["parameter"].get<std::string>() + " = [^;]*;");
        std::istringstream lines(read_text(file));
        int number = 1;
        for (std::string text; std::getline(lines, text); ++number)
            if (std::smatch found; std::regex_search(text, found, form))
                return apply_to_code({{"file", "parameters.glsl"},
                                      {"line", number},
                                      {"from", found.str()},
                                      {"to", fmt::format("{} = {};", facts["parameter"].get<std::string>(),
                                                         facts["to"].dump())}});
        throw Error({file.string()}, "has no such parameter", "make the folder anew");
    }
    const std::filesystem::path folder = emptied_folder();
    own_scene_ = ws_.scene->loaded().file;
    auto gltf = TickQuestion::parse(read_text(own_scene_));
    gltf[TickQuestion::json_pointer(pointer)] = facts["to"];
    const std::filesystem::path file = folder / std::filesystem::path(own_scene_).filename();
    image::write_text(file, gltf.dump());
    hold_exposure();
    ws_.open(file.string());
    ws_.messages.notify("The scene is changed. I takes it back.");
    return Change::redraw;
}

Changes Tick::take_back() {
    is_changed_ = false;
    if (std::exchange(holds_exposure_, false)) ws_.exposure.make_automatic();
    ws_.messages.notify("The change is taken back.");
    if (!own_scene_.empty()) {
        ws_.open(std::exchange(own_scene_, {}));
        return Change::redraw;
    }
    std::erase(ws_.options.shaders, std::exchange(ws_.options.changed_code, {}));
    return ws_.reload_shaders();
}

void Tick::draw_question(const TickQuestion& question) {
    const auto put = [](const std::string& text) { ImGui::TextUnformatted(in_plain_letters(text).c_str()); };
    put(question["ask"]);
    ImGui::Separator();
    if (!shows_answer_)
        ImGui::TextDisabled("%s shows the answer.", ws_.keys.text(Command::show_answer).c_str());
    else
        for (const TickQuestion& line : question["answer"]) put("- " + line.get<std::string>());
    ImGui::Separator();
    ImGui::TextDisabled("%s %s", ws_.keys.text(Command::try_question).c_str(),
                        question["kind"] == "pixel" ? "probes the pixel."
                                                    : "makes the change, and takes it back.");
    ImGui::TextDisabled("%s goes to the next question.", ws_.keys.text(Command::next_question).c_str());
}

Changes Tick::draw(const Overlay& overlay) {
    const PanelPlace place = ws_.layout.take_side(side::examination);
    if (!place.is_shown) return {};
    const bool is_docked = place.area.has_value();
    if (is_docked) {
        place_next_window(*place.area);
    } else {
        const vec2 window = ws_.window_size();
        const float width = std::min(440.0f * overlay.scale, 0.5f * window.x);
        ImGui::SetNextWindowPos({10.0f, ws_.layout.rest().size.y - 10.0f}, ImGuiCond_FirstUseEver,
                                {0.0f, 1.0f});
        ImGui::SetNextWindowSizeConstraints({width, 0.0f}, {width, 0.7f * window.y});
    }
    if (ImGui::Begin(side::examination, nullptr, ws_.ui.panel_flags(is_docked))) {
        if (is_docked) heading(side::examination, ws_.ui);
        ImGui::PushTextWrapPos();
        if (making_.valid()) ImGui::TextDisabled("Questions are being made ...");
        if (!questions_.empty()) {
            ImGui::TextUnformatted(fmt::format("Question {} of {}: {}", at_ + 1, questions_.size(),
                                               questions_[at_]["title"].get<std::string>())
                                       .c_str());
            draw_question(questions_[at_]);
        }
        for (const std::string& line : missing_) ImGui::TextDisabled("%s", in_plain_letters(line).c_str());
        ImGui::PopTextWrapPos();
    }
    if (!is_docked) keep_in_viewport();
    ImGui::End();
    return {};
}

std::unique_ptr<Tool> make_tick(Workspace& workspace) {
    if (!workspace.options.is_examined) return nullptr;
    return std::make_unique<Tick>(workspace);
}

} // namespace sr::viewer
