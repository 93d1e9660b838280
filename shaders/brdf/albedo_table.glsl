// Albedos of the lobes (the share of uniform white light that they reflect), tabulated over √cosθ_o and roughness (tools/ltc/): as sampling them
// each time would be dear. Sheen over ∛cosθ_o and roughness^⅔: it shines at grazing, the more so the smoother it is.
//
// 64 columns. 2 × 32 rows, which fill half of them: a, b, c, ∫ D V cosθ; Schlick's part of that, nothing, the mean over
// cosθ_o of 1 - ∫ D V cosθ. 64 rows: ∫ f cosθ of sheen.
uniform sampler2D ltc_table;

const vec2 ltc_table_size = vec2(64.0, 128.0);

vec2 ltc_place(float cos_o, float alpha, float layer) {
    vec2 at = vec2(sqrt(cos_o), sqrt(alpha)) * 31.0 + 0.5;
    return vec2(at.x, at.y + 32.0 * layer) / ltc_table_size;
}

float E_ggx(float cos_o, float alpha) { return textureLod(ltc_table, ltc_place(cos_o, alpha, 0.0), 0.0).w; }
float mean_loss_ggx(float alpha) { return textureLod(ltc_table, ltc_place(0.5, alpha, 1.0), 0.0).z; }

float E_charlie(float cos_o, float alpha) {
    vec2 at = pow(vec2(cos_o, alpha), vec2(1.0 / 3.0)) * 63.0 + 0.5;
    return textureLod(ltc_table, vec2(at.x, at.y + 64.0) / ltc_table_size, 0.0).x;
}
