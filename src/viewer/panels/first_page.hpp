#pragma once
// First page of a window without a scene: a file is dropped, typed, browsed for, or chosen from recent ones
// and the bundled scenes.
#include "gl/object.hpp"
#include "viewer/document/thumbnails.hpp"
#include "viewer/options.hpp"
#include "viewer/panels/file_browser.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace sr::viewer {

class FirstPage {
public:
    explicit FirstPage(std::vector<SampleScene> samples);

    /// Gives the keyboard back to the typed path.
    void request_focus() { browser_.request_focus(); }
    /// As FileBrowser has it.
    std::string take_completed() { return browser_.take_completed(); }
    bool wants_frame() const { return browser_.wants_focus() || wants_frame_; }

    /// Goes on making thumbnails. @return true if there is another one, or a file that gets none
    bool update();
    /// Says, once, why no thumbnails are made; empty if they are.
    std::string take_problem();
    /// Stops making them: a scene is there.
    void rest() { thumbnails_.reset(); }

    /// Draws the page. @return the chosen scene file, once
    std::optional<std::string> draw(const Area& room, const Ui& ui);

private:
    std::optional<std::string> draw_browser(float width, const Ui& ui);
    std::optional<std::string> draw_lists(const Ui& ui);
    bool draw_row(const std::string& file, const std::string& name, const std::string& what);
    const gl::Texture* picture_of(const std::string& file);

    std::vector<SampleScene> samples_;
    std::vector<std::string> recent_;
    FileBrowser browser_;
    std::optional<Thumbnails> thumbnails_;
    std::map<std::string, gl::Texture> pictures_; // by file
    bool may_read_ = false; // a picture, in this frame: one a frame, so that no frame takes long
    bool wants_frame_ = false;
    bool is_problem_taken_ = false;
};

} // namespace sr::viewer
