#pragma once
// A suite of golden-image tests: one JSON file (assets/golden_suite.schema.json), one entry a test.
#include "compare/options.hpp"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sr::golden {

/// A pixel whose value is known in closed form, so that a golden cannot preserve a wrong picture.
struct KnownPixel {
    int x = 0;
    int y = 0;
    std::array<double, 3> radiance{}; // R, G, B [the image's unit]
    double relative = 0.01;           // how far off it may be: |value - radiance| ≤ relative · radiance
};

/// One image that is made and compared.
struct GoldenTest {
    std::string name; // also its files' name
    std::string description;
    std::vector<std::string> tags;
    /// The words of the command. "{steradian}" is this program, "{out}" the image that it has to write.
    std::vector<std::string> command;
    std::string scene;              // as written in the suite; empty for an external command
    std::string extension = ".exr"; // of its image
    double time_limit = 60.0;       // [s]
    std::vector<compare::Tolerance> tolerances;
    bool allow_nonfinite = false;
    std::optional<compare::PixelRegion> region;
    std::filesystem::path mask;               // empty: none
    std::vector<std::filesystem::path> noise; // standard errors; empty: none
    std::vector<KnownPixel> pixels;
    std::string
        renderer; // who renders it, where neither the picture nor a file beside it says so; may be empty
    /// Beginnings of the names of law and truth tests that must not have failed when its golden is approved.
    std::vector<std::string> guards;
};

/// The renderer whose pictures become goldens. A renderer is it if its strings begin with these.
struct ReferenceRenderer {
    std::string gl_renderer; // beginning of GL_RENDERER, e.g. "llvmpipe"
    std::string gl_version;  // beginning of GL_VERSION; may be empty
};

struct Suite {
    std::filesystem::path file;
    std::string sha256; // of the file
    std::string name;
    std::filesystem::path folder;  // the suite file's; commands run there
    std::filesystem::path goldens; // where the golden images lie
    std::filesystem::path laws;    // JUnit XML with the results of law and truth tests; empty: none
    std::optional<ReferenceRenderer> renderer;
    std::vector<GoldenTest> tests;

    std::filesystem::path golden_of(const GoldenTest& test) const {
        return goldens / (test.name + test.extension);
    }
};

/// The file of the alternate `label` of a test: GOLDENS/alternates/LABEL/NAME.exr. An alternate is another
/// driver's picture of a test, approved beside its golden; it holds only for the renderer that made it.
std::filesystem::path alternate_of(const Suite& suite, const GoldenTest& test, std::string_view label);

/// The labels of the test's alternates, in order.
std::vector<std::string> alternates_of(const Suite& suite, const GoldenTest& test);

/// The file beside a picture that says who rendered it: PICTURE.json, {"renderer": "…", "version": "…"}.
std::filesystem::path sidecar_of(const std::filesystem::path& picture);

/// @throws Error for a label that cannot be a folder's name.
void check_label(const std::string& label);

/// The name of the files of a test in an output folder, without extension: the test's name, in which each
/// byte that artifact stores refuse (\" : < > | * ?) and % stand as %XX. A long one ends with a fingerprint.
std::string file_name_of(const std::string& test);

/// The files in the folder of the goldens that no test of the suite names, in order. Hidden files do not
/// count.
std::vector<std::filesystem::path> orphans_of(const Suite& suite);

/// Reads a suite. @throws Error with file:line:column for broken JSON, an unknown or missing key, a value of
/// a wrong kind, a name that is used twice or cannot be a file's, a tolerance that does not parse.
Suite load_suite(const std::filesystem::path& file);

} // namespace sr::golden
