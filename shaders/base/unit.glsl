// v at length 1, whatever its length is; `otherwise` where v is zero or not finite. The square of a length leaves the
// range of floats long before the length does, so v is brought to a middling length first.
vec3 unit_or(vec3 v, vec3 otherwise) {
    float largest = max(abs(v.x), max(abs(v.y), abs(v.z)));
    bool has_direction = largest >= 1.18e-38 && largest <= 3.4e38; // the range of normal floats
    return has_direction ? normalize(v / largest) : otherwise;
}
