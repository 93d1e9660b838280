// The display settings, as constants that the viewer overlays: software GL executes both sides of every branch, and a window
// is drawn at every frame.
const bool is_false_color = false;
const int view_kind = 0;               // as in view.glsl
const float view_without = 0.0;        // a quotient without divisor
const vec3 colormap_colors[2] = vec3[2](vec3(0.0), vec3(1.0)); // the viewer sets those of src/image/colormap.hpp
const int comparison = 0;              // 0: none, 1: wipe, 2: difference, 3: the other's red, 0 to 1, as on the colour map
const bool is_scaled = true;           // the film has another size than the window
const bool is_film_displayed = false;  // the film is the light of a screen already, 0 to 1
const bool is_other_displayed = false; // so is the other
const bool has_frozen_pixels = false;         // some of the film's pixels have fewer samples: pixel_weights says which
