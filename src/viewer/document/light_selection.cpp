#include "viewer/document/light_selection.hpp"

#include <algorithm>
#include <utility>

namespace sr::viewer {

LightSelection& LightSelection::operator=(std::size_t entry) {
    select({entry});
    return *this;
}

void LightSelection::select(std::vector<std::size_t> entries) {
    entries_ = std::move(entries);
    range_from_ = active().value_or(0);
}

void LightSelection::toggle(std::size_t entry) {
    if (std::erase(entries_, entry) == 0) entries_.push_back(entry);
    range_from_ = active().value_or(0);
}

void LightSelection::extend_to(std::size_t entry) {
    if (entries_.empty()) return select({entry});
    entries_.clear();
    const bool is_down = entry >= range_from_;
    for (std::size_t i = range_from_;; is_down ? ++i : --i) {
        entries_.push_back(i);
        if (i == entry) return;
    }
}

std::optional<std::size_t> LightSelection::active() const {
    return entries_.empty() ? std::nullopt : std::optional(entries_.back());
}

bool LightSelection::contains(std::size_t entry) const { return std::ranges::count(entries_, entry) > 0; }

void LightSelection::follow(const std::vector<LightEntry>& before, const LightEditor& now) {
    std::vector<std::size_t> same;
    for (const std::size_t entry : entries_)
        if (const auto there = entry < before.size() ? now.entry_like(before[entry]) : std::nullopt)
            same.push_back(*there);
    if (same != entries_) select(std::move(same));
}

void LightSelection::keep_below(std::size_t count) {
    if (std::erase_if(entries_, [=](std::size_t entry) { return entry >= count; }) > 0)
        range_from_ = active().value_or(0);
}

} // namespace sr::viewer
