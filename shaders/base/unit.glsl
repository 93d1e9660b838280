// Directions of vectors that may have none.

// v at unit length, even where its square leaves the range of floats; `other` where v is zero or not finite.
vec3 unit_or(vec3 v, vec3 other) {
    float size = max(abs(v.x), max(abs(v.y), abs(v.z)));
    return size > 0.0 && size < 1e38 ? normalize(v / size) : other;
}

// The half vector h between wi and wo; n where the two are opposite, at the horizon, where every h is as good.
vec3 half_vector(vec3 wi, vec3 wo, vec3 n) {
    vec3 h = wi + wo;
    return dot(h, h) > 0.0 ? normalize(h) : n;
}
