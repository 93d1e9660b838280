// f_r in two summands, for estimators that integrate each in a way of its own.
struct Lobes {
    vec3 diffuse;  // what scatters everywhere [1/sr]
    vec3 specular; // what is near the GGX lobe [1/sr]
};

float largest(vec3 v) { return max(v.x, max(v.y, v.z)); }
