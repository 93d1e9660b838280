// Coordinates of a point in the depth maps of a point on an emitter, and the ray of a texel.
//
// A face looks along one of the axes, in the sense of its sign; its (u, v) are the next two axes, each times scale.
#include "interface/maps.glsl"

struct MapPlace {
    int layer;   // negative: nothing stands there
    int axis;    // of the face: 0, 1, 2
    float side;  // of the face: 1 or -1
    vec2 at;     // in texels
};

vec3 to_face(vec3 d, int axis) { return axis == 0 ? d.yzx : axis == 1 ? d.zxy : d; }
vec3 from_face(vec3 d, int axis) { return axis == 0 ? d.zxy : axis == 1 ? d.yzx : d; }

float face_layer(MapPoint y, int axis, float side) {
    vec2 pair = axis == 0 ? y.layers.xy : axis == 1 ? y.layers.zw : y.layers_z;
    return side > 0.0 ? pair.x : pair.y;
}

MapPlace map_place(MapPoint y, vec3 x) {
    vec3 d = (x - y.origin) * y.axes;
    vec3 size = abs(d);
    int axis = 2;
    if (y.kind == cube_map && size.x >= max(size.y, size.z)) axis = 0;
    else if (y.kind == cube_map && size.y >= size.z) axis = 1;
    vec3 uvw = to_face(d, axis);
    float side = y.kind == orthographic_map || uvw.z >= 0.0 ? 1.0 : -1.0;
    vec2 uv = y.scale * (y.kind == orthographic_map ? uvw.xy : uvw.xy / abs(uvw.z));
    float layer = max(abs(uv.x), abs(uv.y)) <= 1.0 ? face_layer(y, axis, side) : -1.0;
    return MapPlace(int(layer), axis, side, (0.5 * uv + 0.5) * float(textureSize(map_triangles, 0).x));
}

// The light that goes through a texel's centre: origin + s direction; in perspective s = 1 is at the depth 1 m.
struct TexelRay {
    vec3 origin;
    vec3 direction;
    float footprint;  // of the texel, in perspective over s [m]
};

TexelRay texel_ray(MapPoint y, MapPlace place, vec2 texel) {
    float size = float(textureSize(map_triangles, 0).x);
    vec2 uv = ((texel + 0.5) / size * 2.0 - 1.0) / y.scale;
    float footprint = 2.0 / (size * y.scale);
    if (y.kind == orthographic_map) return TexelRay(y.origin + y.axes * vec3(uv, 0.0), y.axes[2], footprint);
    return TexelRay(y.origin, y.axes * from_face(vec3(uv, place.side), place.axis), footprint);
}
