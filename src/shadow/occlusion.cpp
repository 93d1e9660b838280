#include "shadow/occlusion.hpp"

#include "core/error.hpp"
#include "shadow/device.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace sr::shadow {
namespace {

constexpr std::size_t packet = Occlusion::packet;

constexpr float offset_share = 1.0f / 131072.0f;     // 2^-17
constexpr float last_share = 1.0f - 1.0f / 32768.0f; // 1 - 2^-15

float largest(vec3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// From `origin` to where the query looks.
Ray ray_from(vec3 origin, const Query& query) {
    if (query.is_infinite) return {origin, query.to_emitter, std::numeric_limits<float>::infinity()};
    return {origin, query.x + query.to_emitter - origin, last_share};
}

/// The part of a ray's origin that all rays from a point share.
struct Receiver {
    vec3 n{0.0f};          // of the triangle's plane; 0 if it has none
    float distance = 0.0f; // of the point from the plane [m]
    float offset = 0.0f;   // along n, away from the plane [m]

    Receiver() = default;
    Receiver(vec3 x, std::span<const vec3, 3> triangle) {
        const vec3 a = triangle[0];
        n = glm::cross(triangle[1] - a, triangle[2] - a);
        const float length = glm::length(n);
        n = length > 0.0f ? n / length : vec3(0.0f);
        offset = offset_share * std::max({largest(a), largest(triangle[1]), largest(triangle[2])});
        distance = glm::dot(x - a, n);
    }

    Ray ray_to(const Query& query) const {
        const float side = glm::dot(n, query.to_emitter) < 0.0f ? -1.0f : 1.0f;
        return ray_from(query.x + (side * offset - distance) * n, query);
    }
};

/// A packet of rays with what the filter must know of each. Embree hands back the pointer to its first
/// member.
struct Context {
    RayContext embree;
    const Casters* casters;
    std::array<int, packet> light;
    std::array<float, packet> end; // t of the whole ray's end
    std::array<vec3, packet> V;
};

/// Takes away from V what one hit does. @return whether the ray is stopped.
bool is_stopped(Context& context, unsigned ray, float t, vec3 direction, std::uint32_t triangle, float u,
                float v) {
    const Casters& casters = *context.casters;
    const Caster& caster = casters.casters[casters.caster_of[triangle]];
    if (caster.emits_as.contains(context.light[ray]) && t >= context.end[ray] * (1.0f - caster.own_share))
        return false;
    if (is_passed_from_behind(casters, triangle, context.light[ray], direction)) return false;
    context.V[ray] *= transmittance(casters, triangle, u, v, direction);
    return context.V[ray] == vec3(0.0f);
}

/// Embree's callback for each hit on a surface that is not plain: an invalidated hit lets the ray go on.
void filter(const RTCFilterFunctionNArguments* arguments) {
    auto& context = *reinterpret_cast<Context*>(arguments->context);
    const unsigned n = arguments->N;
    for (unsigned i = 0; i < n; ++i) {
        if (arguments->valid[i] == 0) continue;
        const unsigned ray = RTCRayN_id(arguments->ray, n, i);
        const std::uint32_t geometry = RTCHitN_geomID(arguments->hit, n, i);
        const std::uint32_t triangle =
            static_cast<std::uint32_t>(context.casters->casters[geometry].first_triangle)
            + RTCHitN_primID(arguments->hit, n, i);
        const vec3 direction(RTCRayN_dir_x(arguments->ray, n, i), RTCRayN_dir_y(arguments->ray, n, i),
                             RTCRayN_dir_z(arguments->ray, n, i));
        if (!is_stopped(context, ray, RTCRayN_tfar(arguments->ray, n, i), direction, triangle,
                        RTCHitN_u(arguments->hit, n, i), RTCHitN_v(arguments->hit, n, i)))
            arguments->valid[i] = 0;
    }
}

/// One instance's triangles; degenerate and non-finite ones are Embree's to leave out.
void attach(RTCDevice device, RTCScene scene, const Casters& casters, std::size_t index) {
    const auto first = static_cast<std::size_t>(casters.casters[index].first_triangle);
    const std::size_t end = index + 1 < casters.casters.size()
                                ? static_cast<std::size_t>(casters.casters[index + 1].first_triangle)
                                : casters.triangle_count();
    const std::size_t count = end - first;
    if (count == 0) return;
    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* corners = static_cast<vec3*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                               RTC_FORMAT_FLOAT3, sizeof(vec3), 3 * count));
    auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), count));
    if (corners && indices) {
        std::copy_n(&casters.corners[3 * first], 3 * count, corners);
        for (std::uint32_t i = 0; i < 3 * count; ++i) indices[i] = i;
        if (!casters.casters[index].is_plain()) rtcSetGeometryOccludedFilterFunction(geometry, filter);
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(scene, geometry, static_cast<unsigned>(index));
    }
    rtcReleaseGeometry(geometry);
}

void set_lane(RTCRay8& rays, std::size_t lane, const Ray& ray) {
    rays.org_x[lane] = ray.origin.x;
    rays.org_y[lane] = ray.origin.y;
    rays.org_z[lane] = ray.origin.z;
    rays.dir_x[lane] = ray.direction.x;
    rays.dir_y[lane] = ray.direction.y;
    rays.dir_z[lane] = ray.direction.z;
    rays.tnear[lane] = 0.0f;
    rays.tfar[lane] = ray.end;
    rays.time[lane] = 0.0f;
    rays.mask[lane] = ~0u;
    rays.id[lane] = static_cast<unsigned>(lane);
    rays.flags[lane] = 0;
}

} // namespace

struct Occlusion::Tree {
    Device device;
    RTCScene scene = rtcNewScene(device.handle());

    Tree() = default;
    ~Tree() { rtcReleaseScene(scene); }
    Tree(const Tree&) = delete;
    Tree& operator=(const Tree&) = delete;
};

Occlusion::Occlusion(const Casters& casters) : casters_(casters), tree_(std::make_unique<Tree>()) {
    rtcSetSceneFlags(tree_->scene, RTC_SCENE_FLAG_ROBUST); // watertight along edges
    for (std::size_t i = 0; i < casters.casters.size(); ++i)
        attach(tree_->device.handle(), tree_->scene, casters, i);
    rtcCommitScene(tree_->scene);
    tree_->device.require_content();
}

Occlusion::~Occlusion() = default;

void Occlusion::answer(std::span<const Query> queries, std::span<vec3> V) const {
    require(queries.size() == V.size(), "one answer a query");
    Context context{};
    context.casters = &casters_;
    RTCRay8 rays{};
    Receiver receiver;
    const Query* last = nullptr; // whose receiver it is
    for (std::size_t first = 0; first < queries.size(); first += packet) {
        const std::size_t count = std::min(packet, queries.size() - first);
        alignas(32) std::array<int, packet> valid{};
        for (std::size_t lane = 0; lane < count; ++lane) {
            const Query& query = queries[first + lane];
            const bool is_on_line = query.triangle < 0;
            if (!is_on_line && !(last && last->triangle == query.triangle && last->x == query.x)) {
                receiver = {query.x, casters_.triangle(static_cast<std::uint32_t>(query.triangle))};
                last = &query;
            }
            const Ray ray = is_on_line ? ray_from_line(query) : receiver.ray_to(query);
            set_lane(rays, lane, ray);
            context.light[lane] = query.light;
            context.end[lane] = ray.end;
            context.V[lane] = vec3(1.0f);
            valid[lane] = -1;
        }
        trace(valid.data(), tree_->scene, context.embree, rays);
        for (std::size_t lane = 0; lane < count; ++lane) // Embree marks what is stopped by minus infinity
            V[first + lane] = rays.tfar[lane] < 0.0f ? vec3(0.0f) : context.V[lane];
    }
}

Ray ray_from_line(const Query& query) {
    const vec3 wi = glm::normalize(query.to_emitter);
    return ray_from(query.x + offset_share * largest(query.x) * wi, query);
}

Ray ray_of(const Query& query, std::span<const vec3, 3> triangle) {
    return Receiver(query.x, triangle).ray_to(query);
}

} // namespace sr::shadow
