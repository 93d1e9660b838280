#pragma once
// Warnings: features of a file that the picture lacks.
//
// One thing that is broken (a texture, an animation's channel, a lamp, a camera) costs that thing and one
// warning. Under --strict every warning is an Error instead.
#include "core/error.hpp"

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sr::gltf {

/// The text in double quotes, without control characters and at most 80 bytes of it.
std::string in_quotes(std::string_view text);

class Warnings {
public:
    /// `file` is what the lines begin with. `is_strict`: whatever would be a warning throws.
    explicit Warnings(std::string file, bool is_strict = false)
        : file_(std::move(file)), is_strict_(is_strict) {}

    /// Counts `count` more occurrences of `what`; `meaning` says what becomes of them.
    /// @throws Error where warnings are strict
    void add(std::string_view what, std::string_view meaning, std::size_t count = 1);

    /// Adds the warnings of `other` that are new; those that are known keep their count.
    void add_new(const Warnings& other);

    /// Warns of an error that cost one thing; `loss` says what is done without it.
    /// @throws Error, the same, where warnings are strict
    void add_loss(const Error& error, std::string_view loss);

    /// Reads one thing of the file. An Error becomes the warning of its loss.
    /// @return whether the thing could be read
    /// @throws Error where warnings are strict
    template<class Read>
    bool attempt(std::string_view loss, Read&& read) {
        try {
            read();
            return true;
        } catch (const Error& error) {
            add_loss(error, loss);
            return false;
        }
    }

    /// "file: what (3 times): meaning", in the order of first occurrence; one line each, at most `max_lines`
    /// and one that counts the rest.
    std::vector<std::string> lines() const;

    static constexpr std::size_t max_lines = 100;

private:
    struct Entry {
        std::string what;
        std::string meaning;
        std::size_t count = 0;
    };
    void append(std::string_view what, std::string_view meaning, std::size_t count, bool is_counted_again);

    std::string file_;
    bool is_strict_ = false;
    std::vector<Entry> entries_;
    std::map<std::pair<std::string, std::string>, std::size_t> places_; // in entries_
    std::size_t untold_ = 0;                                            // warnings beyond max_lines
};

} // namespace sr::gltf
