#include "assignment/regions.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <regex>

namespace sr::assignment {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size() - 1);
        lines.push_back(text.substr(at, end + 1 - at));
        at = end + 1;
    }
    return lines;
}

struct RegionMarker {
    bool begins = false;
    bool is_solution = false; // of a reference, where a bare "// end" is enough
    std::string name;         // empty only for an end
};

/// "// begin [solution] A3.2 …", "// end [solution]", "// end A3.2 …". Any other comment is none, so that
/// students may write "// begin with h".
std::optional<RegionMarker> region_marker(const std::string& line) {
    static const std::regex form(
        R"(^\s*//\s*(begin|end)(\s+solution)?(?:\s+(helpers|[A-Z][0-9]+\.[0-9]+)\b.*)?\s*$)");
    std::smatch found;
    const std::string content = line.substr(0, line.find_last_not_of("\r\n") + 1);
    if (!std::regex_match(content, found, form)) return std::nullopt;
    if (found[1] == "begin" && !found[3].matched) return std::nullopt;
    return RegionMarker{found[1] == "begin", found[2].matched, found[3]};
}

int number_of(std::size_t index) { return static_cast<int>(index) + 1; }

} // namespace

std::vector<Region> regions_of(const std::string& text, const std::string& place) {
    std::vector<Region> regions;
    std::optional<RegionMarker> open;
    const std::vector<std::string> lines = lines_of(text);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const auto marker = region_marker(lines[i]);
        const bool is_bare = marker && !marker->begins && marker->name.empty();
        if (!marker || (is_bare && !(open && open->is_solution))) {
            if (open) regions.back().text += lines[i];
            continue;
        }
        const Location here{place, number_of(i)};
        if (!marker->begins) {
            if (!open || (!is_bare && marker->name != open->name))
                throw Error(here, fmt::format("the end of {} without its begin", marker->name),
                            fmt::format("write // begin {} before its code", marker->name));
            regions.back().end_line = number_of(i);
            open.reset();
            continue;
        }
        if (open)
            throw Error(here, fmt::format("{} begins before the end of {}", marker->name, open->name),
                        fmt::format("write // end {} before it", open->name));
        if (std::ranges::find(regions, marker->name, &Region::name) != regions.end())
            throw Error(here, fmt::format("the region {} is there twice", marker->name), "keep one of them");
        regions.push_back({marker->name, number_of(i), 0, {}});
        open = marker;
    }
    if (open)
        throw Error({place, regions.back().begin_line}, fmt::format("the region {} has no end", open->name),
                    fmt::format("write // end {} behind its code", open->name));
    return regions;
}

std::string included_name(std::string_view region) { return fmt::format("region/{}.glsl", region); }

std::string with_includes(const std::string& text, const std::string& place,
                          const std::vector<std::string>& names) {
    const std::vector<Region> regions = regions_of(text, place);
    const std::vector<std::string> lines = lines_of(text);
    std::string result;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const int line = number_of(i);
        const auto region = std::ranges::find_if(
            regions, [line](const Region& r) { return r.begin_line < line && line < r.end_line; });
        if (region == regions.end() || std::ranges::find(names, region->name) == names.end())
            result += lines[i];
        // The marker's own line takes the include: a region may have no line between its markers.
        const auto begun = std::ranges::find(regions, line, &Region::begin_line);
        if (begun != regions.end() && std::ranges::find(names, begun->name) != names.end())
            result += fmt::format("#include \"{}\"\n", included_name(begun->name));
    }
    return result;
}

std::vector<Variant> variants_of(const std::string& text, const std::string& place) {
    static const std::regex form(R"(^\s*//\s*(mistake|solution)\s+([A-Za-z0-9_]+)\s*$)");
    std::vector<Variant> variants;
    const std::vector<std::string> lines = lines_of(text);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        std::smatch found;
        const std::string content = lines[i].substr(0, lines[i].find_last_not_of("\r\n") + 1);
        if (std::regex_match(content, found, form)) {
            const std::string name = found[2];
            if (std::ranges::find(variants, name, &Variant::name) != variants.end())
                throw Error({place, number_of(i)}, fmt::format("the variant {} is there twice", name),
                            "give each a name of its own");
            variants.push_back({name, found[1] == "mistake", number_of(i) + 1, {}});
        } else if (!variants.empty()) {
            variants.back().text += lines[i];
        } else if (content.find_first_not_of(" \t") != std::string::npos && !content.starts_with("//")) {
            throw Error({place, number_of(i)}, "code before the first variant",
                        "write // mistake NAME or // solution NAME before it");
        }
    }
    return variants;
}

} // namespace sr::assignment
