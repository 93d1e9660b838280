#include "gltf/warnings.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace sr::gltf {

void Warnings::add(std::string_view what, std::string_view meaning, std::size_t count) {
    if (count == 0) return;
    const auto is_same = [&](const Entry& entry) { return entry.what == what && entry.meaning == meaning; };
    auto found = std::find_if(entries_.begin(), entries_.end(), is_same);
    if (found == entries_.end()) found = entries_.insert(found, {std::string(what), std::string(meaning), 0});
    found->count += count;
}

std::vector<std::string> Warnings::lines() const {
    std::vector<std::string> lines;
    lines.reserve(entries_.size());
    for (const Entry& entry : entries_) {
        const std::string times = entry.count > 1 ? fmt::format(" ({} times)", entry.count) : "";
        lines.push_back(fmt::format("{}: {}{}: {}", file_, entry.what, times, entry.meaning));
    }
    return lines;
}

} // namespace sr::gltf
