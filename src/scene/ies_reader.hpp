#pragma once
// The text of an IES file: lines up to TILT=, then numbers wherever the lines break.
#include <string>
#include <string_view>

namespace sr::scene {

class IesReader {
public:
    IesReader(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {}

    bool is_at_end() const { return text_.empty(); }
    /// The rest of the current line, without its end.
    std::string_view line();
    /// Returns whether another number (or anything else) follows.
    bool has_more();
    /// The next number, between spaces, commas or line ends. @throws Error calling it `what`
    double number(std::string_view what);
    /// The same, whole and within bounds.
    int whole(std::string_view what, int smallest, int largest);
    std::size_t size_left() const { return text_.size(); }

    /// @throws Error at the line of what was read last
    [[noreturn]] void fail(std::string_view what, std::string_view what_to_do) const;

private:
    void skip_separators();

    std::string_view text_;
    std::string name_;
    int next_line_ = 1; // of text_'s begin
    int line_ = 1;      // of what was read last
};

} // namespace sr::scene
