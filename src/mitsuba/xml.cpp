#include "mitsuba/xml.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

namespace sr::mitsuba {
namespace {

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
        case '&': result += "&amp;"; break;
        case '<': result += "&lt;"; break;
        case '>': result += "&gt;"; break;
        case '"': result += "&quot;"; break;
        default: result += c;
        }
    }
    return result;
}

std::string attribute(std::string_view key, std::string_view value) {
    return value.empty() ? std::string() : fmt::format(" {}=\"{}\"", key, escaped(value));
}

} // namespace

void Xml::indent() { text_.append(2 * open_.size(), ' '); }

void Xml::open(std::string_view tag, std::string_view type, std::string_view name, std::string_view id) {
    indent();
    // The version that Mitsuba 3 reads without renaming anything.
    const std::string_view version = tag == "scene" ? "3.0.0" : "";
    text_ += fmt::format("<{}{}{}{}{}>\n", tag, attribute("version", version), attribute("type", type),
                         attribute("name", name), attribute("id", id));
    open_.emplace_back(tag);
}

void Xml::close() {
    require(!open_.empty(), "an element is open");
    const std::string tag = open_.back();
    open_.pop_back();
    indent();
    text_ += fmt::format("</{}>\n", tag);
}

void Xml::leaf(std::string_view tag, std::string_view name, const std::string& value) {
    indent();
    text_ += fmt::format("<{}{} value=\"{}\"/>\n", tag, attribute("name", name), escaped(value));
}

void Xml::triple(std::string_view tag, std::string_view name, vec3 value) {
    indent();
    text_ += fmt::format("<{}{} x=\"{}\" y=\"{}\" z=\"{}\"/>\n", tag, attribute("name", name), value.x,
                         value.y, value.z);
}

void Xml::number(std::string_view name, float value) { leaf("float", name, fmt::format("{}", value)); }
void Xml::whole(std::string_view name, int value) { leaf("integer", name, fmt::format("{}", value)); }
void Xml::flag(std::string_view name, bool value) { leaf("boolean", name, value ? "true" : "false"); }
void Xml::text(std::string_view name, std::string_view value) { leaf("string", name, std::string(value)); }
void Xml::vector(std::string_view name, vec3 value) { triple("vector", name, value); }
void Xml::point(std::string_view name, vec3 value) { triple("point", name, value); }
void Xml::color(std::string_view name, vec3 value) {
    leaf("rgb", name, fmt::format("{}, {}, {}", value.x, value.y, value.z));
}

void Xml::transform(std::string_view name, const mat4& matrix) {
    open("transform", "", name);
    std::string values;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            values += fmt::format("{}{}", values.empty() ? "" : " ", matrix[column][row]);
    leaf("matrix", "", values);
    close();
}

void Xml::reference(std::string_view id) {
    indent();
    text_ += fmt::format("<ref{}/>\n", attribute("id", id));
}

const std::string& Xml::result() const {
    require(open_.empty(), "every element is closed");
    return text_;
}

} // namespace sr::mitsuba
