#pragma once
// Settings that do not go together.
#include "settings/render_settings.hpp"

namespace sr::picture {

/// Refuses them before any work is done. @throws BadSetting
void check(const settings::RenderSettings& settings);

} // namespace sr::picture
