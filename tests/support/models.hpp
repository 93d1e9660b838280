#pragma once
// Real glTF files that are not part of the project (several are not free enough to ship).
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sr::testing {

/// $STERADIAN_MODELS, or ../shared/models beside the source tree; absent if there is no such folder.
std::optional<std::filesystem::path> models_folder();

/// The glTF models that a package of the system brings (Debian's assimp-testmodels), in folders below this
/// one; absent if it is not installed.
std::optional<std::filesystem::path> packaged_models_folder();

/// The glTF files below a folder, in order.
std::vector<std::filesystem::path> models_below(const std::filesystem::path& folder);

/// The bundled assets/ folder of the source tree.
std::filesystem::path assets_folder();

/// The source tree itself.
std::filesystem::path source_folder();

/// A fresh, empty folder of that name, under the build tree. It is the running test's own: others run beside
/// it.
std::filesystem::path scratch_folder(const std::string& name);

} // namespace sr::testing
