// Journal tool: keeps unsaved edits in a file, and offers those that an earlier run has left.
#include "viewer/document/journal.hpp"
#include "viewer/tools/tool.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <string>
#include <utility>
#include <vector>

namespace sr::viewer {
namespace {

/// The names of a few things, for a message.
std::string few_names(const std::vector<std::string>& names) {
    constexpr std::size_t max_names = 4;
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), max_names); ++i)
        text += fmt::format("{}{}", i > 0 ? ", " : "", names[i].empty() ? "one without a name" : names[i]);
    return names.size() <= max_names ? text : fmt::format("{} and {} more", text, names.size() - max_names);
}

} // namespace

class KeepEdits : public Tool {
public:
    using Tool::Tool;
    ~KeepEdits() override {
        if (journal_) write();
    }

    Changes update(double seconds) override;
    void notice(Changes changes) override;

private:
    void offer();
    void ask_about(const LostEdits& lost);
    bool write() const { return journal_->write(ws_.scene->lights(), ws_.scene->loaded().source.json_hash); }

    std::optional<Journal> journal_; // of the scene that is shown
    bool is_outdated_ = false;
    bool is_kept_ = true; // false once edits could not be written
    double age_ = 0.0;    // of the journal [s]
};

void KeepEdits::notice(Changes changes) {
    is_outdated_ = is_outdated_ || changes.has(Change::lights) || changes.has(Change::shadows);
}

/// A drag is written when it has ended.
Changes KeepEdits::update(double seconds) {
    constexpr double interval = 0.3; // [s] between two writes at least
    const std::string& file = ws_.scene->loaded().file;
    if (!journal_ || journal_->scene_file() != file) {
        if (journal_) journal_->remove();
        journal_.emplace(file);
        is_kept_ = true;
        offer();
        return Change::redraw;
    }
    age_ += seconds;
    if (!is_outdated_ || ws_.is_time_held || age_ < interval) return {};
    is_outdated_ = false;
    age_ = 0.0;
    const bool was_kept = std::exchange(is_kept_, write());
    if (is_kept_ || !was_kept) return {};
    ws_.messages.notify(
        ws_.keys.hint("The journal of edits cannot be written, so that a crash would lose them. Save them",
                      Command::save_as)
        + ".");
    return Change::redraw;
}

void KeepEdits::offer() {
    const LoadedScene& loaded = ws_.scene->loaded();
    const FoundJournals found = journal_->find(ws_.scene->lights().edits(), loaded.source.json_hash);
    if (!found.problems.empty())
        ws_.messages.fail("Unsaved edits of an earlier run cannot be read.",
                          fmt::format("{}", fmt::join(found.problems, "\n")));
    if (found.newest) ask_about(*found.newest);
}

void KeepEdits::ask_about(const LostEdits& lost) {
    const auto remove = [journal = lost.journal] {
        std::error_code ignored;
        std::filesystem::remove(journal, ignored);
    };
    const auto recover = [this, edits = lost.edits, remove] {
        ws_.scene->lights().recover(edits);
        write();
        remove();
        ws_.messages.notify(fmt::format("The edits are recovered. {} saves them, {} undoes them.",
                                        ws_.keys.text(Command::save_as), ws_.keys.text(Command::undo_light)));
        ws_.answered |= Change::lights | Change::shadows;
    };
    const std::size_t all = lost.count + lost.missing.size();
    std::string text = fmt::format("An earlier run ended without saving {} edited {} of {}.", all,
                                   all == 1 ? "light or material" : "lights or materials",
                                   std::filesystem::path(ws_.scene->loaded().file).filename().string());
    if (lost.has_file_changed) text += " The file has changed since, so they are found by their names.";
    if (!lost.missing.empty())
        text += fmt::format(
            " {}: {}.", lost.count == 0 ? "None is found" : "Not found, and lost if you recover the others",
            few_names(lost.missing));
    // Enter gives the first answer, so that it never discards.
    const Answer discard{GLFW_KEY_D, "Discard them", remove}, later{0, "Ask again at the next start"};
    if (lost.count > 0)
        ws_.ask({text, {{GLFW_KEY_R, "Recover them", recover}, discard, later}});
    else
        ws_.ask({text, {{GLFW_KEY_K, "Keep them", {}}, discard, later}});
}

std::unique_ptr<Tool> make_keep_edits(Workspace& workspace) { return std::make_unique<KeepEdits>(workspace); }

} // namespace sr::viewer
