#pragma once
// Selected lights, as entries of a LightEditor.
#include "viewer/document/light_edits.hpp"

#include <vector>

namespace sr::viewer {

/// The selected lights. One of them is active: fields show its values, and a range begins at it.
class LightSelection {
public:
    /// Selects one light alone.
    LightSelection& operator=(std::size_t entry);
    /// Selects these lights. The last one is active.
    void select(std::vector<std::size_t> entries);
    void reset() { entries_.clear(); }
    /// Adds a light, which becomes active, or takes it away.
    void toggle(std::size_t entry);
    /// Selects all lights between this one and the active one, or the one that a range began at.
    void extend_to(std::size_t entry);

    explicit operator bool() const { return !entries_.empty(); }
    /// The active light. Needs a selection.
    std::size_t operator*() const { return entries_.back(); }
    std::optional<std::size_t> active() const;
    bool contains(std::size_t entry) const;
    std::size_t count() const { return entries_.size(); }
    /// All of them, the active one last.
    const std::vector<std::size_t>& entries() const { return entries_; }

    /// Selects the same lights after they have changed their places in the list: `before` was the list. Those
    /// that are gone are not selected any more.
    void follow(const std::vector<LightEntry>& before, const LightEditor& now);
    /// Drops what is beyond a list of this length.
    void keep_below(std::size_t count);

    bool operator==(const LightSelection&) const = default;

private:
    std::vector<std::size_t> entries_; // the active one last
    std::size_t range_from_ = 0;       // where a range began
};

} // namespace sr::viewer
