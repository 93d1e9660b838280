#include "golden/law_record.hpp"

#include "core/error.hpp"
#include "golden/bytes_of_file.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace sr::golden {
namespace {

/// A start, end or empty tag of an XML text, without its angle brackets.
struct Tag {
    std::string_view name;
    std::string_view attributes;
    bool is_end = false;
};

/// The tags of an XML text in turn; comments, CDATA, declarations and text are passed over.
class Tags {
public:
    explicit Tags(std::string_view xml) : rest_(xml) {}

    bool next(Tag& tag) {
        while (true) {
            const auto open = rest_.find('<');
            if (open == std::string_view::npos) return false;
            rest_.remove_prefix(open);
            if (rest_.starts_with("<!--"))
                skip_behind("-->");
            else if (rest_.starts_with("<![CDATA["))
                skip_behind("]]>");
            else if (rest_.starts_with("<!") || rest_.starts_with("<?"))
                skip_behind(">");
            else
                return read(tag);
        }
    }

private:
    void skip_behind(std::string_view mark) {
        const auto end = rest_.find(mark);
        rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + mark.size());
    }

    bool read(Tag& tag) {
        std::size_t end = 1;
        for (char quote = 0; end < rest_.size() && (quote != 0 || rest_[end] != '>'); ++end) {
            const char c = rest_[end];
            if (quote == 0 && (c == '"' || c == '\''))
                quote = c;
            else if (c == quote)
                quote = 0;
        }
        std::string_view inside = rest_.substr(1, end - 1);
        rest_.remove_prefix(std::min(end + 1, rest_.size()));
        tag.is_end = inside.starts_with('/');
        if (tag.is_end) inside.remove_prefix(1);
        const auto name_end = std::min(inside.find_first_of(" \t\r\n/"), inside.size());
        tag.name = inside.substr(0, name_end);
        tag.attributes = inside.substr(name_end);
        return true;
    }

    std::string_view rest_;
};

std::string unescaped(std::string_view text) {
    constexpr std::array<std::pair<std::string_view, char>, 5> entities{
        {{"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}, {"&amp;", '&'}}};
    std::string result;
    while (!text.empty()) {
        const auto found =
            std::ranges::find_if(entities, [&](const auto& e) { return text.starts_with(e.first); });
        result += found == entities.end() ? text.front() : found->second;
        text.remove_prefix(found == entities.end() ? 1 : found->first.size());
    }
    return result;
}

std::string attribute(const Tag& tag, std::string_view name) {
    const std::string key = " " + std::string(name) + "=";
    const auto at = tag.attributes.find(key);
    if (at == std::string_view::npos || at + key.size() >= tag.attributes.size()) return {};
    const std::string_view rest = tag.attributes.substr(at + key.size());
    const auto end = rest.find(rest.front(), 1);
    return end == std::string_view::npos ? std::string() : unescaped(rest.substr(1, end - 1));
}

} // namespace

std::vector<std::string> LawRecord::failed_among(std::span<const std::string> guards) const {
    std::vector<std::string> names;
    for (const std::string& name : failed)
        if (std::ranges::any_of(guards, [&](const std::string& guard) { return name.starts_with(guard); }))
            names.push_back(name);
    return names;
}

LawRecord read_law_record(const std::filesystem::path& file) {
    const std::string xml = bytes_of_file(file);
    LawRecord record;
    std::string open_case;
    const auto fail_open_case = [&] {
        if (!open_case.empty() && (record.failed.empty() || record.failed.back() != open_case))
            record.failed.push_back(open_case);
    };
    Tags tags(xml);
    for (Tag tag; tags.next(tag);) {
        if (tag.name == "testcase" && !tag.is_end) {
            ++record.tests;
            open_case = attribute(tag, "name");
            const std::string status = attribute(tag, "status"); // as CTest writes it
            if (status == "fail" || status == "notrun") fail_open_case();
        } else if (!tag.is_end && (tag.name == "failure" || tag.name == "error")) {
            fail_open_case();
        }
    }
    if (record.tests == 0)
        throw Error({file.string()}, "no <testcase> in it", "record laws with ctest --output-junit FILE");
    return record;
}

} // namespace sr::golden
