#pragma once
// V on the CPU: Embree's occlusion rays.
#include "shadow/casters.hpp"
#include "shadow/origin.hpp"

#include <memory>

namespace sr::shadow {

/// The casters as Embree traces them.
class Occlusion {
public:
    /// Builds Embree's tree. `casters` must outlive this. @throws Error if Embree fails.
    explicit Occlusion(const Casters& casters);
    ~Occlusion();

    /// V of each query, for red, green and blue: 1 where nothing stands between x and the emitter's point, 0
    /// where something does, and the product of what transparent surfaces let through. For any number of
    /// threads at once.
    void answer(std::span<const Query> queries, std::span<vec3> V) const;

private:
    struct Tree;
    const Casters& casters_;
    std::unique_ptr<Tree> tree_;
};

} // namespace sr::shadow
