// The display settings, as constants that the viewer overlays: software GL executes both sides of every branch, and a window
// is drawn at every frame.
const int shown_curve = 2;             // as in tone_curve.glsl
const bool is_false_color = false;
const int comparison = 0;              // 0: none, 1: wipe, 2: difference, 3: the other's red, 0 to 1, as false colour
const bool is_scaled = true;           // the film has another size than the window
const bool is_other_displayed = false; // the other is the light of a screen already, 0 to 1
const bool is_resting = false;         // some of the film's pixels have fewer samples: rest_weights says which
