#include "viewer/document/view_history.hpp"

namespace sr::viewer {

void ViewHistory::visit(const std::string& view) {
    constexpr std::size_t max_views = 200;
    if (!views_.empty() && views_[at_] == view) return;
    if (!views_.empty()) views_.resize(at_ + 1);
    views_.push_back(view);
    if (views_.size() > max_views) views_.erase(views_.begin());
    at_ = views_.size() - 1;
}

std::optional<std::string> ViewHistory::earlier() {
    if (at_ == 0) return std::nullopt;
    return views_[--at_];
}

std::optional<std::string> ViewHistory::later() {
    if (at_ + 1 >= views_.size()) return std::nullopt;
    return views_[++at_];
}

} // namespace sr::viewer
