#include "assignment/parameters.hpp"

#include "core/error.hpp"
#include "golden/sha256.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sr::assignment {
namespace {

/// A number in [0, 1) from a text, evenly spread over texts.
double fraction_of(const std::string& text) {
    const golden::Digest digest = golden::sha256(text);
    double fraction = 0.0;
    for (int i = 5; i >= 0; --i) fraction = (fraction + digest[static_cast<std::size_t>(i)]) / 256.0;
    return fraction;
}

/// As GLSL and JSON both read it.
std::string number_text(double value) {
    std::string text = fmt::format("{}", value);
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text;
}

} // namespace

Parameters parameters_of(const Assignment& assignment, const std::string& student) {
    Parameters values;
    for (const Parameter& parameter : assignment.parameters) {
        const double u = fraction_of(assignment.id + "\n" + student + "\n" + parameter.name);
        if (!parameter.values.empty()) {
            const auto index = static_cast<std::size_t>(u * static_cast<double>(parameter.values.size()));
            values[parameter.name] = parameter.values[std::min(index, parameter.values.size() - 1)];
        } else {
            const double scale = std::pow(10.0, parameter.decimals);
            values[parameter.name] =
                std::round((parameter.low + u * (parameter.high - parameter.low)) * scale) / scale;
        }
    }
    return values;
}

std::string parameters_glsl(const Assignment& assignment, const Parameters& parameters) {
    std::string text = "// Your own numbers, which the checks use, too. Do not change them.\n";
    for (const Parameter& parameter : assignment.parameters)
        text += fmt::format("const float {} = {}; // {}{}\n", parameter.name,
                            number_text(parameters.at(parameter.name)), parameter.about,
                            parameter.unit.empty() ? "" : fmt::format(" [{}]", parameter.unit));
    return text;
}

std::string substituted(const std::string& text, const Parameters& parameters, const std::string& place) {
    std::string result;
    std::size_t done = 0;
    for (std::size_t at = text.find("{{"); at != std::string::npos; at = text.find("{{", at + 1)) {
        const std::size_t end = text.find("}}", at);
        const std::string name = end == std::string::npos ? "" : text.substr(at + 2, end - at - 2);
        if (name.empty()
            || name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789")
                   != std::string::npos)
            continue;
        const auto found = parameters.find(name);
        if (found == parameters.end()) {
            const auto line = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
            throw Error({place, static_cast<int>(line) + 1}, fmt::format("no parameter {}", name),
                        "name it in \"parameters\" of assignment.json");
        }
        result += text.substr(done, at - done) + number_text(found->second);
        done = end + 2;
    }
    return result + text.substr(done);
}

std::string substituted_json(std::string text, const Parameters& parameters, const std::string& place) {
    for (const auto& [from, to] : {std::pair{"\"{{", "{{"}, {"}}\"", "}}"}})
        for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at))
            text.replace(at, 3, to);
    return substituted(text, parameters, place);
}

} // namespace sr::assignment
