// The choice of an entry by its cumulative distribution: the first whose cdf is above u. A cdf lies in the alpha of consecutive
// texels; its guide tells where to begin. Keep in sync with src/render/gpu/light_texels.hpp.
uniform samplerBuffer environment_texels;

// The share of the cdf that begins at texel `first` which entry i has.
float cdf_share(int first, int i) {
    float share = texelFetch(environment_texels, first + i).a;
    return i > 0 ? share - texelFetch(environment_texels, first + i - 1).a : share;
}

// The entry of a cdf that u falls on.
struct CdfEntry {
    int i;
    float share; // of the entry
    float u;     // the place within the entry
};

// Half as many texels as a guide of this cdf has slots: about one for eight entries.
int guide_texels(int count) { return 1 << max(findMSB(count) - 3, 0); }

// The slot of the guide that u falls in holds the first and the last entry that may be meant: bisection from there takes a step or
// two (Chen & Asau 1974). The number of slots is a power of two, so that u finds its slot without rounding.
CdfEntry cdf_entry(int first, int count, int guide, float u) {
    int slots = 2 * guide_texels(count);
    int slot = min(int(u * float(slots)), slots - 1);
    vec4 bounds = texelFetch(environment_texels, guide + slot / 2);
    bool is_odd = (slot & 1) == 1;
    int low = int(is_odd ? bounds.y : bounds.x);
    int high = int(is_odd ? bounds.z : bounds.y);
    while (low < high) {
        int middle = (low + high) / 2;
        bool is_beyond = texelFetch(environment_texels, first + middle).a > u;
        high = is_beyond ? middle : high;
        low = is_beyond ? low : middle + 1;
    }
    float below = low > 0 ? texelFetch(environment_texels, first + low - 1).a : 0.0;
    float share = texelFetch(environment_texels, first + low).a - below;
    return CdfEntry(low, share, clamp((u - below) / share, 0.0, 1.0));
}
