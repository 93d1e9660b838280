#include "support/address.hpp"
#include "support/glsl_table.hpp"
#include "support/models.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

using namespace sr;
using namespace sr::testing;

namespace {

/// tools/truth/brdf_table.py: twelve inputs and three outputs a line, under one line of names.
struct Table {
    std::vector<Row> inputs;
    std::vector<vec3> f_r; // [1/sr], as Mitsuba's plugin has it
};

Table stored_table() {
    std::ifstream file(source_folder() / "tests/truth/references/brdf.csv");
    Table table;
    std::string line;
    std::getline(file, line);
    while (std::getline(file, line)) {
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream numbers(line);
        Row row;
        for (vec4& part : row) numbers >> part.x >> part.y >> part.z >> part.w;
        vec3 f_r;
        numbers >> f_r.x >> f_r.y >> f_r.z;
        if (!numbers) ADD_FAILURE() << "cannot be read: " << line;
        table.inputs.push_back(row);
        table.f_r.push_back(f_r);
    }
    return table;
}

const Test brdf("truth.brdf.metallic_roughness", [] {
    const Table table = stored_table();
    ASSERT_EQ(table.inputs.size(), 400u);
    const auto ours = evaluate("#include \"brdf/f_r.glsl\"\n",
                               "Surface x;\n"
                               "x.n = vec3(0.0, 0.0, 1.0);\n"
                               "x.metallic = a.w; x.alpha = b.w; x.base_color = vec3(c.xy, 0.5);\n"
                               "x.F0_dielectric = vec3(c.z); x.specular = c.w;\n"
                               "return vec4(f_r(x, a.xyz, b.xyz), 1.0);",
                               table.inputs);
    double worst = 0.0;
    for (std::size_t i = 0; i < ours.size(); ++i)
        for (int c = 0; c < 3; ++c)
            worst = std::max(worst, std::abs(double(ours[i][c]) / double(table.f_r[i][c]) - 1.0));
    EXPECT_LT(worst, 1e-5); // both count in 32-bit floats; measured: 9e-7
    ::testing::Test::RecordProperty("max_relative_difference", std::to_string(worst));
});

} // namespace
