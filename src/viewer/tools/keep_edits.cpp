// Journal tool: keeps unsaved edits in a file, and offers those that an earlier run has left.
#include "viewer/document/journal.hpp"
#include "viewer/tools/tool.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <utility>

namespace sr::viewer {
class KeepEdits : public Tool {
public:
    using Tool::Tool;
    ~KeepEdits() override {
        if (journal_) journal_->write(ws_.scene->lights());
    }

    Changes update(double seconds) override;
    void notice(Changes changes) override;

private:
    void offer();

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
    const bool was_kept = std::exchange(is_kept_, journal_->write(ws_.scene->lights()));
    if (is_kept_ || !was_kept) return {};
    ws_.messages.notify(
        ws_.keys.hint("The journal of edits cannot be written, so that a crash would lose them. Save them",
                      Command::save_as)
        + ".");
    return Change::redraw;
}

void KeepEdits::offer() {
    const auto lost = journal_->find(ws_.scene->lights().edits());
    if (!lost) return;
    const auto remove = [journal = lost->journal] {
        std::error_code ignored;
        std::filesystem::remove(journal, ignored);
    };
    const auto recover = [this, edits = lost->edits, remove] {
        ws_.scene->lights().recover(edits);
        journal_->write(ws_.scene->lights());
        remove();
        ws_.messages.notify(fmt::format("The edits are recovered. {} saves them, {} undoes them.",
                                        ws_.keys.text(Command::save_as), ws_.keys.text(Command::undo_light)));
        ws_.answered |= Change::lights | Change::shadows;
    };
    ws_.ask({fmt::format("An earlier run ended without saving {} edited {} of {}.{}", lost->count,
                         lost->count == 1 ? "light or material" : "lights or materials",
                         std::filesystem::path(ws_.scene->loaded().file).filename().string(),
                         lost->has_file_changed ? " The file has changed since." : ""),
             {{GLFW_KEY_R, "Recover them", recover},
              {GLFW_KEY_D, "Discard them", remove},
              {0, "Ask again at the next start"}}});
}

std::unique_ptr<Tool> make_keep_edits(Workspace& workspace) { return std::make_unique<KeepEdits>(workspace); }

} // namespace sr::viewer
