#pragma once
// First page of a window without a scene: a file is dropped, typed, browsed for, or chosen from recent ones
// and the bundled scenes.
#include "viewer/options.hpp"
#include "viewer/panels/file_browser.hpp"

#include <optional>
#include <string>
#include <vector>

namespace sr::viewer {

class FirstPage {
public:
    explicit FirstPage(std::vector<SampleScene> samples);

    /// Gives the keyboard back to the typed path.
    void request_focus() { browser_.request_focus(); }
    bool wants_focus() const { return browser_.wants_focus(); }

    /// Draws the page. @return the chosen scene file, once
    std::optional<std::string> draw(const Area& room, const Ui& ui);

private:
    std::optional<std::string> draw_browser(float width, const Ui& ui);
    std::optional<std::string> draw_lists(const Ui& ui);

    std::vector<SampleScene> samples_;
    std::vector<std::string> recent_;
    FileBrowser browser_;
};

} // namespace sr::viewer
