// The frame's points on the emitters and the depth maps that were made from each. Keep in sync with src/render/map_points.cpp.
uniform isampler2DArray map_triangles; // the first shadow caster that light meets, by its index; -1: none
uniform samplerBuffer map_points;      // a texel a light: its first point's first texel, how many points, and whether
                                       // it has an extent, so that another point is its middle; behind them the
                                       // points, seven texels each

const int perspective_map = 0;  // one face
const int cube_map = 1;         // up to six faces
const int orthographic_map = 2; // one face

// A point on an emitter; of a sun or an environment, a direction to it.
struct MapPoint {
    vec3 position;    // [m]; of a sun or an environment: unit, towards it
    vec3 normal;      // of a flat emitter, unit
    float extent;     // of a flat emitter: one over the point's density [m²]
    vec2 uv;          // where the emitter's texture is read
    int kind;         // of the maps
    vec3 origin;      // of the maps: the point itself, of orthographic ones the middle of the scene [m]
    mat3 axes;        // of the maps, orthonormal; the third is the way of the light
    float scale;      // from axes to texture coordinates in [-1, 1]
    uint seed;        // of this frame's choice of transparent casters
    vec4 layers;      // of the faces +x, -x, +y, -y ...
    vec2 layers_z;    // ... and +z, -z; negative: nothing is there
};

int point_count(int light) { return int(texelFetch(map_points, light).y); }
bool has_extent(int light) { return texelFetch(map_points, light).z != 0.0; }

MapPoint map_point(int light, int index) {
    int first = int(texelFetch(map_points, light).x) + 7 * index;
    vec4 t0 = texelFetch(map_points, first);
    vec4 t1 = texelFetch(map_points, first + 1);
    vec4 t2 = texelFetch(map_points, first + 2);
    vec4 t3 = texelFetch(map_points, first + 3);
    vec4 t4 = texelFetch(map_points, first + 4);
    vec4 t5 = texelFetch(map_points, first + 5);
    mat3 axes = mat3(t3.xyz, t4.xyz, cross(t3.xyz, t4.xyz));
    uint seed = uint(t5.z) + 65536u * uint(t5.w);
    return MapPoint(t0.xyz, t1.xyz, t1.w, t5.xy, int(t0.w), t2.xyz, axes, t2.w, seed,
                    texelFetch(map_points, first + 6), vec2(t3.w, t4.w));
}
