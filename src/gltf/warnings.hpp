#pragma once
// What a file asks for and does not get, one line for each kind of thing however often it occurs.
#include <string>
#include <string_view>
#include <vector>

namespace sr::gltf {

class Warnings {
public:
    /// `file` is what the lines begin with.
    explicit Warnings(std::string file) : file_(std::move(file)) {}

    /// Counts `count` more occurrences of `what`; `meaning` says what becomes of them or what to do.
    void add(std::string_view what, std::string_view meaning, std::size_t count = 1);

    /// "file: what (3 times): meaning", in the order of first occurrence.
    std::vector<std::string> lines() const;

private:
    struct Entry {
        std::string what;
        std::string meaning;
        std::size_t count = 0;
    };

    std::string file_;
    std::vector<Entry> entries_;
};

} // namespace sr::gltf
