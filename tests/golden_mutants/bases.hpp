#pragma once
// Three pictures of different kinds, made by code at any size: a linear render, a photograph, a user
// interface.
#include "image/image.hpp"

#include <string>

namespace sr::testing {

struct Extent {
    int width = 256;
    int height = 256;
};

/// A glossy ball on a checkered floor before a wall, with a lamp in sight, a wire one pixel wide and an
/// object of seven pixels. Linear light; alpha is 0 behind the floor's end.
struct RenderBase {
    float roughness = 0.12f; // of the ball
    bool has_object = true;
    bool has_wire = true;
    float wire = 0.8f;   // its radiance
    int wire_offset = 0; // [pixels]
    int wire_end = 0;    // [pixels] that its lower end lacks
    bool has_shadow = true;
    float shadow_offset = 0.0f; // [pixels] to the right
    float shadow_leak = 0.0f;   // share of the key light that reaches the shadow
    bool has_gloss = true;
    float gloss_offset = 0.0f; // [pixels] of the highlights to the right
    float lamp = 40.0f;
    float ball_radius = 1.0f; // times the usual one
    float ball_offset = 0.0f; // [pixels] to the right
    float tile = 1.0f;        // times the radiance of one tile of the floor
    int supersampling = 2;    // samples of a pixel along an edge
};

/// R, G, B, A.
image::Image render_base(Extent size, const RenderBase& options = {});

/// The render with layers: those of its two lights, "key" and "fill", and "depth.Z".
image::Image layered_render_base(Extent size, const RenderBase& options = {});

/// Discs of random size and colour that cover one another (a model of natural images: Lee, Mumford, Huang
/// 2001, "Occlusion models for natural images"), shaded, with grain. sRGB codes of 8 bits.
image::Image photo_base(Extent size);

/// A window with buttons, fields and text. Its parts have the same size in pixels in every frame.
struct InterfaceBase {
    std::string label = "Save";
    std::string amount = "1,380.00";
    std::string title = "Settings";
    int label_offset = 0;           // [pixels]
    bool has_rule = true;           // one pixel high, up to 800 wide
    int rule_offset = 0;            // [pixels]
    bool has_icon = true;           // seven pixels
    float icon = 0.1f;              // its red
    bool has_focus_ring = true;     // one pixel wide
    bool has_caret = false;         // one pixel wide
    bool has_badge = true;          // a dot of five pixels
    int badge_offset = 0;           // [pixels]
    int badge_pixels = 5;           // of the five
    bool has_round_corners = false; // of the button: without their last pixel
    int kerned = 0; // letters of the label before one that stands a pixel further to the right
    std::string body = "some noise is on line 1,380"; // every third line of the text
    int button_growth = 0;                            // [pixels] to the right
    float button = 0.86f;                             // its blue
    bool has_antialiasing = true;
    float text_size = 2.0f; // [pixels] of a dot of the font
};

/// R, G, B: sRGB codes of 8 bits.
image::Image interface_base(Extent size, const InterfaceBase& options = {});

/// Values as 8-bit codes.
void round_to_codes(image::Image& image);

} // namespace sr::testing
