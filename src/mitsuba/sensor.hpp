#pragma once
// The camera and its film.
#include "mitsuba/xml.hpp"
#include "scene/camera.hpp"

namespace sr::mitsuba {

/// Writes the <sensor>: the same view as the renderer's, a box filter of one pixel, linear RGB in 32-bit
/// floats.
/// @param width, height of the picture [pixels]
void write_sensor(Xml& xml, const scene::Camera& camera, int width, int height);

} // namespace sr::mitsuba
