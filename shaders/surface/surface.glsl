// A point x of a surface, with all that the equation asks of it. What the features of a material leave out
// (interface/features.glsl) is not to be read.
struct Surface {
    vec3 position;        // x [m]
    vec3 n;               // shading normal, unit, on the side of the viewer
    vec3 unmapped_n;      // n as it is without its normal map
    vec3 base_color;      // linear
    float metallic;
    float alpha;          // GGX width: roughness²
    vec3 F0_dielectric;   // reflectance of the dielectric part at normal incidence
    float specular;       // weight of the dielectric part's specular layer
    vec3 emission;        // L_e [cd/m²]
    int triangle;         // that x lies on: its index among the shadow casters; -1: on a line or point, which casts none
    float coverage;       // how much of the light from behind is kept back: alpha of the base colour, 1 if opaque; of
                          // glass the mean over the channels

    float roughness;      // as typed
    vec3 t;               // unit, across n: along it the GGX width is alphas.x, across it alphas.y
    vec2 alphas;
    float clearcoat;      // weight of the coat
    float clearcoat_alpha;
    vec3 clearcoat_n;     // the coat's own shading normal
    vec3 sheen_color;
    float sheen_alpha;    // roughness² of the sheen
    float iridescence;    // weight of the thin film
    float film_ior;
    float film_thickness; // [nm]
    vec3 specular_color;  // as the material states it: part of F0, or the colour of a lobe

    float transmission;   // share of the base that lets light straight through
    vec3 through;         // what of the light from behind goes on to the viewer, alpha included
    float alpha_coverage; // alpha of the base colour, 1 if opaque
    float diffuse_transmission; // share of the diffuse base that scatters to the other side
    vec3 diffuse_transmission_color;
};

// alpha = roughness²: Burley 2012, section 5.4, and glTF 2.0 Appendix B. A perfect mirror (alpha = 0) has no density
// that a point light could be seen in; below 1e-4 the square of alpha² leaves the range of floats in comfort.
const float min_alpha = 1e-4;

float alpha_of(float roughness) { return max(roughness * roughness, min_alpha); }
