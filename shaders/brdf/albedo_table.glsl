// What lobes reflect of white light from all sides, tabulated over √cosθ_o and roughness (tools/ltc/): as sampling them
// each time would be dear.
uniform sampler2D ltc_table; // 32 columns of √cosθ_o, 2 × 32 rows of roughness: a, b, c, ∫ D V cosθ; Schlick's part of that,
                             // ∫ f cosθ of sheen, the mean over cosθ_o of 1 - ∫ D V cosθ

vec2 ltc_place(float cos_o, float alpha, float layer) {
    const float size = 32.0;
    vec2 at = (vec2(sqrt(cos_o), sqrt(alpha)) * (size - 1.0) + 0.5) / size;
    return vec2(at.x, 0.5 * (at.y + layer));
}

float E_ggx(float cos_o, float alpha) { return textureLod(ltc_table, ltc_place(cos_o, alpha, 0.0), 0.0).w; }
float E_charlie(float cos_o, float alpha) { return textureLod(ltc_table, ltc_place(cos_o, alpha, 1.0), 0.0).y; }
float mean_loss_ggx(float alpha) { return textureLod(ltc_table, ltc_place(0.5, alpha, 1.0), 0.0).z; }
