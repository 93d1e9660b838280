#pragma once
// Views of a camera in the order in which a person came to them, as arguments of `render --camera`.
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace sr::viewer {

/// A list with a place in it, as browsers have: a new view drops those after the current one. The oldest of
/// 200 views goes.
class ViewHistory {
public:
    /// Comes to a view. The current one again is no news.
    void visit(const std::string& view);
    /// Goes back or forward by one. @return the view there; absent at the end of the list
    std::optional<std::string> earlier();
    std::optional<std::string> later();

private:
    std::vector<std::string> views_;
    std::size_t at_ = 0; // of the current view
};

} // namespace sr::viewer
