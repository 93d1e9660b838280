#pragma once
// Sums that a few large terms do not decide.
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace sr::compare {

/// The largest of many values: as many as `count`, and one more.
class LargestValues {
public:
    explicit LargestValues(std::size_t count) : count_(count) {}

    void add(double value) {
        if (values_.size() > count_ && value <= values_.back()) return;
        if (values_.size() > count_) values_.pop_back();
        values_.insert(std::ranges::upper_bound(values_, value, std::greater<>{}), value);
    }

    /// The loss of the sum of all if the first `count` become as large as the next.
    double excess() const {
        const double next = values_.size() > count_ ? std::max(values_.back(), 0.0) : 0.0;
        double sum = 0.0;
        for (const double value : values_) sum += std::max(value - next, 0.0);
        return sum;
    }

private:
    std::size_t count_;
    std::vector<double> values_; // the largest first
};

/// Sums in which a few terms at either end count as much as the next one there does: Winsorised sums (Tukey
/// 1962, "The Future of Data Analysis", Sec. 18). A change of all terms is kept.
class WinsorisedSums {
public:
    /// @param limited the number of terms at either end of a sum
    WinsorisedSums(std::size_t sums, std::size_t limited)
        : above_(sums, LargestValues(limited)), below_(sums, LargestValues(limited)) {}

    void add(std::size_t sum, double term) { (term > 0.0 ? above_ : below_)[sum].add(std::abs(term)); }

    /// The plain sum, or the Winsorised one if that is nearer to 0: neither a few large terms nor the lack of
    /// them moves it away from 0.
    double nearer_to_0(std::size_t sum, double plain) const {
        const double winsorised = plain - above_[sum].excess() + below_[sum].excess();
        return std::abs(winsorised) < std::abs(plain) ? winsorised : plain;
    }

private:
    std::vector<LargestValues> above_;
    std::vector<LargestValues> below_;
};

} // namespace sr::compare
