#pragma once
// A curve of one variable as a table whose steps grow with its argument, as eyes and floats do.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

namespace sr::image {

/// Tabulates a function over [2^first, 2^last] with 256 steps an octave, at steps where a float's bits are
/// round, so that finding one is a shift. Linear between them: a power x^k is met within 2e-6 of its value.
/// Below 2^first it is linear from the value at 0; above 2^last it stays.
class LogTable {
public:
    template<typename Function>
    LogTable(Function&& f, int first, int last)
        : start_(bits(std::ldexp(1.0f, first)) >> shift),
          low_(std::ldexp(1.0f, first)),
          high_(std::ldexp(1.0f, last)),
          at_zero_(static_cast<float>(f(0.0f))) {
        const std::uint32_t steps = (bits(high_) >> shift) - start_;
        for (std::uint32_t i = 0; i <= steps + 1; ++i)
            values_.push_back(static_cast<float>(f(std::bit_cast<float>((start_ + i) << shift))));
    }

    float operator()(float x) const {
        if (!(x > low_)) return at_zero_ + (values_[0] - at_zero_) * (std::max(x, 0.0f) / low_);
        const std::uint32_t pattern = bits(std::min(x, high_));
        const std::uint32_t step = (pattern >> shift) - start_;
        const float part = static_cast<float>(pattern & ((1u << shift) - 1u)) * (1.0f / (1u << shift));
        return values_[step] + (values_[step + 1] - values_[step]) * part;
    }

private:
    static constexpr int shift = 23 - 8; // 8 of the mantissa's 23 bits choose the step
    static std::uint32_t bits(float x) { return std::bit_cast<std::uint32_t>(x); }

    std::uint32_t start_;
    float low_;
    float high_;
    float at_zero_;
    std::vector<float> values_;
};

} // namespace sr::image
