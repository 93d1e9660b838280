#pragma once
// A text field that is to take the keyboard.

namespace sr::viewer {

/// A panel that appears is not drawn for a frame or two, so the wish is repeated until it is fulfilled, or
/// for as many frames as that can take (it may be collapsed).
class FocusWish {
public:
    void wish() { frames_left_ = 10; }
    bool is_open() const { return frames_left_ > 0; }
    /// Once a frame: whether the field has the keyboard now.
    void tell(bool is_fulfilled) { frames_left_ = is_fulfilled ? 0 : frames_left_ - 1; }

private:
    int frames_left_ = 0;
};

} // namespace sr::viewer
