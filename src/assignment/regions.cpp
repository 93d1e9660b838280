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
    constexpr std::size_t max_marker = 1000; // std::regex recurses for each character
    if (line.size() > max_marker) return std::nullopt;
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

namespace {

/// Where a function stands in a text: [begin, end), its signature up to its brace.
struct Found {
    std::size_t begin = 0;
    std::size_t brace = 0;
    std::size_t end = 0;
    std::string type;
};

std::size_t partner_of(const std::string& code, std::size_t open) {
    int depth = 0;
    for (std::size_t i = open; i < code.size(); ++i) {
        if (code[i] == code[open]) ++depth;
        if (code[i] == (code[open] == '{' ? '}' : ')') && --depth == 0) return i;
    }
    return std::string::npos;
}

std::optional<Found> definition_of(const std::string& code, const std::string& function) {
    const std::regex form(R"((^|\n)[ \t]*([A-Za-z_]\w*)[ \t]+)" + function + R"([ \t]*\()");
    for (std::sregex_iterator i(code.begin(), code.end(), form), last; i != last; ++i) {
        const auto open = static_cast<std::size_t>(i->position() + i->length()) - 1;
        const std::size_t close = partner_of(code, open);
        if (close == std::string::npos) continue;
        const std::size_t brace = code.find_first_not_of(" \t\r\n", close + 1);
        if (brace == std::string::npos || code[brace] != '{') continue;
        const std::size_t end = partner_of(code, brace);
        if (end == std::string::npos) continue;
        return Found{static_cast<std::size_t>(i->position(2)), brace, end + 1, i->str(2)};
    }
    return std::nullopt;
}

/// The comment lines that end right above `begin`.
std::string comment_above(const std::string& text, std::size_t begin) {
    std::size_t from = begin;
    while (from > 0) {
        const std::size_t line = from >= 2 ? text.rfind('\n', from - 2) + 1 : 0; // npos + 1 is 0
        const std::size_t first = text.find_first_not_of(" \t", line);
        if (text.compare(first, 2, "//") != 0) break;
        from = line;
    }
    std::string comment;
    for (std::size_t at = from; at < begin;) {
        const std::size_t end = text.find('\n', at) + 1;
        const std::string line = text.substr(at, end - at);
        if (line.find("// stub:") == std::string::npos && line.find("// keep:") == std::string::npos)
            comment += line;
        at = end;
    }
    return comment;
}

std::string body_for(const std::string& type) {
    if (type == "void") return "    not_implemented();\n";
    if (type == "vec4") return "    return not_implemented();\n";
    if (type == "vec3") return "    return not_implemented().xyz;\n";
    if (type == "vec2") return "    return not_implemented().xy;\n";
    if (type == "float") return "    return not_implemented().x;\n";
    if (type == "bool" || type == "int" || type == "uint")
        return fmt::format("    return {}(not_implemented().y);\n", type);
    return {};
}

/// The texts of the lines that begin with a word such as "// stub:".
std::vector<std::string> lines_behind(const std::string& text, const std::string& word) {
    std::vector<std::string> found;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
        const std::size_t begin = at + word.size();
        std::string line = text.substr(begin, text.find('\n', begin) - begin);
        if (line.starts_with(' ')) line.erase(0, 1);
        found.push_back(line);
    }
    return found;
}

} // namespace

std::string without_comments(const std::string& text) {
    std::string code = text;
    enum class In { statement, line, block } in = In::statement;
    for (std::size_t i = 0; i < code.size(); ++i) {
        const std::string_view two = std::string_view(text).substr(i, 2);
        if (in == In::statement && two == "//") in = In::line;
        if (in == In::statement && two == "/*") in = In::block;
        if (in == In::line && text[i] == '\n') in = In::statement;
        const bool closes = in == In::block && two == "*/";
        if (in != In::statement && text[i] != '\n') code[i] = ' ';
        if (closes) {
            code[++i] = ' ';
            in = In::statement;
        }
    }
    return code;
}

LoneBracket lone_bracket(const std::string& text) {
    std::vector<LoneBracket> open;
    int line = 1;
    for (const char c : without_comments(text)) {
        if (c == '\n') ++line;
        if (c == '{' || c == '(' || c == '[') open.push_back({line, c});
        if (c != '}' && c != ')' && c != ']') continue;
        const char partner = c == '}' ? '{' : c == ')' ? '(' : '[';
        if (open.empty()) return {line, c};
        if (open.back().bracket != partner) return open.back();
        open.pop_back();
    }
    return open.empty() ? LoneBracket{} : open.back();
}

std::string stub_of(const std::string& text, const std::vector<std::string>& functions,
                    const std::string& place, int line) {
    const std::string code = without_comments(text);
    const std::vector<std::string> stubs = lines_behind(text, "// stub:");
    std::string result;
    for (const std::string& kept : lines_behind(text, "// keep:")) result += kept + "\n";
    for (const std::string& function : functions) {
        const auto found = definition_of(code, function);
        if (!found)
            throw Error({place, line}, fmt::format("the region does not define {}", function),
                        "define it there, or name another function in the manifest");
        std::string body;
        for (const std::string& stub : stubs) body += "    " + stub + "\n";
        if (body.empty()) body = body_for(found->type);
        if (body.empty())
            throw Error({place, line}, fmt::format("{} returns a {}", function, found->type),
                        "write the student's body as // stub: lines in the region");
        if (!result.empty()) result += "\n";
        result += comment_above(text, found->begin) + text.substr(found->begin, found->brace - found->begin)
                  + "{\n" + body + "}\n";
    }
    return result;
}

} // namespace sr::assignment
