// A point x of a surface, with all that the equation asks of it.
struct Surface {
    vec3 position;        // x [m]
    vec3 n;               // shading normal, unit, on the side of the viewer
    vec3 base_color;      // linear
    float metallic;
    float alpha;          // GGX width: roughness²
    vec3 F0_dielectric;   // reflectance of the dielectric part at normal incidence
    float specular;       // weight of the dielectric part's specular layer
    vec3 emission;        // L_e [cd/m²]
    int triangle;         // that x lies on: its index among the shadow casters
    float coverage;       // alpha of the base colour, 1 if opaque
};
