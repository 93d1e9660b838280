#pragma once
// Fields of a picture that is rendered beside the window's render: size, samples, error.
#include "settings/values.hpp"
#include "viewer/panels/text_form.hpp"

#include <optional>

namespace sr::viewer {

/// A picture that a person asks for.
struct PictureRequest {
    settings::Size size;
    int samples = 0;             // a pixel, at most
    std::optional<double> error; // √relMSE at which it stops; absent: after all samples
};

class PictureFields {
public:
    /// `window`: the size of the picture in the window.
    void show(const PictureRequest& proposed, settings::Size window);
    /// Draws the fields into the current dialog. `is_first`: the size is its first field. @return true if
    /// Enter was pressed in one
    bool draw(TextForm& form, bool is_first);
    /// The fields as values. @throws Error that says which one is wrong
    PictureRequest request() const;

private:
    void draw_sizes();

    settings::Size window_;
    TextForm::Text size_{}, samples_{}, error_{};
};

} // namespace sr::viewer
