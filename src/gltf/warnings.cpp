#include "gltf/warnings.hpp"

#include <fmt/format.h>

namespace sr::gltf {

std::string in_quotes(std::string_view text) {
    constexpr std::size_t max_size = 80;
    std::string line = "\"";
    for (const char c : text.substr(0, max_size)) line += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    if (text.size() > max_size) line += "…";
    return line + '"';
}

void Warnings::append(std::string_view what, std::string_view meaning, std::size_t count,
                      bool is_counted_again) {
    std::pair key{std::string(what), std::string(meaning)};
    const auto found = places_.find(key);
    if (found != places_.end()) {
        if (is_counted_again) entries_[found->second].count += count;
        return;
    }
    if (entries_.size() == max_lines) {
        untold_ += count;
        return;
    }
    entries_.push_back({key.first, key.second, count});
    places_.emplace(std::move(key), entries_.size() - 1);
}

void Warnings::add(std::string_view what, std::string_view meaning, std::size_t count) {
    if (count == 0) return;
    if (is_strict_)
        throw Error({file_}, what, fmt::format("correct it, or leave out --strict (then: {})", meaning));
    append(what, meaning, count, true);
}

void Warnings::add_new(const Warnings& other) {
    for (const Entry& entry : other.entries_) append(entry.what, entry.meaning, entry.count, false);
}

void Warnings::add_loss(const Error& error, std::string_view loss) {
    if (is_strict_) throw error;
    std::string_view text = error.what();
    const std::string prefix = file_ + ": ";
    if (text.starts_with(prefix)) text.remove_prefix(prefix.size());
    append(text, loss, 1, true);
}

std::vector<std::string> Warnings::lines() const {
    std::vector<std::string> lines;
    lines.reserve(entries_.size() + 1);
    for (const Entry& entry : entries_) {
        const std::string times = entry.count > 1 ? fmt::format(" ({} times)", entry.count) : "";
        lines.push_back(fmt::format("{}: {}{}: {}", file_, entry.what, times, entry.meaning));
    }
    if (untold_ > 0)
        lines.push_back(fmt::format("{}: {} further warnings: correct these first", file_, untold_));
    return lines;
}

} // namespace sr::gltf
