#pragma once
// Mitsuba's scene format, element by element.
#include "core/math.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace sr::mitsuba {

/// Writes indented XML. Numbers are the shortest that read back as the same float.
class Xml {
public:
    /// <tag type="type" name="name" id="id">, without those that are empty; to be closed.
    void open(std::string_view tag, std::string_view type = {}, std::string_view name = {},
              std::string_view id = {});
    void close();

    void number(std::string_view name, float value);
    void whole(std::string_view name, int value);
    void flag(std::string_view name, bool value);
    void text(std::string_view name, std::string_view value);
    void vector(std::string_view name, vec3 value);
    void point(std::string_view name, vec3 value);
    void color(std::string_view name, vec3 value);
    /// A <transform> of that name, row by row.
    void transform(std::string_view name, const mat4& matrix);
    /// <ref id="id"/>: the object that was opened under that id.
    void reference(std::string_view id);

    /// Everything so far; all elements are closed.
    const std::string& result() const;

private:
    void leaf(std::string_view tag, std::string_view name, const std::string& value);
    void triple(std::string_view tag, std::string_view name, vec3 value);
    void indent();

    std::string text_{"<?xml version=\"1.0\" encoding=\"utf-8\"?>\n"};
    std::vector<std::string> open_;
};

} // namespace sr::mitsuba
