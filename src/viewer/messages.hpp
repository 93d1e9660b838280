#pragma once
// Messages to the person: the message area, its history, and the error panel.
#include "core/output.hpp"

#include <string>
#include <utility>
#include <vector>

namespace sr::viewer {

class Messages {
public:
    /// `is_verbose`: messages go to stderr as well.
    explicit Messages(bool is_verbose) : is_verbose_(is_verbose) {}

    /// Shows a message in the message area.
    void notify(std::string message) {
        keep(message);
        status_ = std::move(message);
        if (is_verbose_) write_remark(status_);
    }
    /// Shows an error over the picture until clear_error().
    void fail(std::string title, std::string text) {
        error_title_ = std::move(title);
        error_text_ = std::move(text);
        keep(error_title_ + " " + error_text_);
        if (is_verbose_) write_remark(error_text_);
    }
    void clear_error() { error_text_.clear(); }
    /// Writes a line to stderr if verbose, and shows nothing.
    void log(const std::string& line) const {
        if (is_verbose_) write_remark(line);
    }

    const std::string& status() const { return status_; }
    /// The last messages, the newest one last.
    const std::vector<std::string>& history() const { return history_; }
    bool has_error() const { return !error_text_.empty(); }
    const std::string& error_title() const { return error_title_; }
    const std::string& error_text() const { return error_text_; }

private:
    void keep(const std::string& message) {
        constexpr std::size_t max_messages = 200;
        if (!history_.empty() && history_.back() == message) return;
        if (history_.size() == max_messages) history_.erase(history_.begin());
        history_.push_back(message);
    }

    bool is_verbose_;
    std::vector<std::string> history_;
    std::string status_;
    std::string error_title_;
    std::string error_text_; // empty: no error
};

} // namespace sr::viewer
