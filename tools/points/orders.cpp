// Finds orders of the two-dimensional Sobol points (src/render/sampling.cpp) under which pairs of coordinates
// fill the boxes of four and of six dimensions evenly.
//
// Coordinates of a digital sequence are matrices over GF(2) that multiply the digits of the index
// (Niederreiter 1987). The pair (M, P M) is the pair (I, P) of Sobol' in another order, which an upper
// triangular M with ones on its diagonal names. Column after column, the search takes the one with the least
// t of the (t,m,s)-net of the first 2^m points, and the fewest boxes at fault, of all columns or of many
// random ones.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <random>
#include <utility>
#include <vector>

namespace {

constexpr unsigned columns = 20;

/// Rows, the first digit's first; bit k of a row is column k.
using Matrix = std::array<std::uint32_t, columns>;

/// Pascal's triangle modulo 2: by Lucas' theorem, where the digits of the row are among those of the column.
Matrix pascal() {
    Matrix matrix{};
    for (unsigned row = 0; row < columns; ++row)
        for (unsigned column = 0; column < columns; ++column)
            if ((row & ~column) == 0) matrix[row] |= 1u << column;
    return matrix;
}

Matrix product(const Matrix& a, const Matrix& b) {
    Matrix result{};
    for (unsigned row = 0; row < columns; ++row)
        for (unsigned k = 0; k < columns; ++k)
            if ((a[row] >> k & 1u) != 0) result[row] ^= b[k];
    return result;
}

/// Rows that are linearly independent, each in the place of its highest digit.
class Basis {
public:
    /// @return whether the row is independent of those before
    bool add(std::uint32_t row) {
        for (unsigned k = columns; k-- > 0 && row != 0;) {
            if ((row >> k & 1u) == 0) continue;
            if (rows_[k] == 0) {
                rows_[k] = row;
                return true;
            }
            row ^= rows_[k];
        }
        return false;
    }

private:
    std::array<std::uint32_t, columns> rows_{};
};

/// How unevenly 2^m points fill boxes: boxes whose edges are 2^-a, 2^-b, ... each have as many points as
/// their volume says unless the first a rows of the first matrix, b of the second and so on are dependent.
class Unevenness {
public:
    Unevenness(const std::vector<Matrix>& matrices, unsigned m) : matrices_(matrices), m_(m), least_(m + 1) {
        visit(0, 0, Basis());
    }

    unsigned t() const { return m_ + 1 - least_; }
    /// First t, and then the kinds of boxes at fault among the largest ones.
    std::pair<unsigned, unsigned> value() const { return {t(), least_ > m_ ? 0 : faults_[least_]}; }

private:
    void visit(std::size_t dimension, unsigned sum, Basis basis) {
        if (dimension == matrices_.size()) return;
        visit(dimension + 1, sum, basis);
        for (unsigned a = 0; sum < m_; ++a) {
            ++sum;
            if (!basis.add(matrices_[dimension][a] & ((1u << m_) - 1u))) {
                ++faults_[sum];
                least_ = std::min(least_, sum);
                return;
            }
            if (sum >= least_) return; // smaller boxes do not matter any more
            visit(dimension + 1, sum, basis);
        }
    }

    const std::vector<Matrix>& matrices_;
    unsigned m_;
    unsigned least_; // of the sums at fault; m + 1: none
    std::array<unsigned, columns + 1> faults_{};
};

/// Returns M, given the matrices of the coordinates before, and adds its pair to them.
Matrix add_pair(std::vector<Matrix>& before, std::mt19937& random) {
    constexpr unsigned all = 10, tries = 1000; // columns of which all are tried, and how many of the others
    Matrix order{};
    for (unsigned column = 0; column < columns; ++column) {
        std::pair<unsigned, unsigned> least{~0u, ~0u};
        Matrix best{};
        unsigned ties = 0;
        const unsigned count = column < all ? 1u << column : tries;
        for (unsigned i = 0; i < count; ++i) {
            const auto above =
                static_cast<std::uint32_t>(column < all ? i : random() & ((1u << column) - 1u));
            Matrix tried = order;
            for (unsigned row = 0; row <= column; ++row)
                tried[row] |= ((above | 1u << column) >> row & 1u) << column;
            std::vector<Matrix> matrices = before;
            matrices.push_back(tried);
            matrices.push_back(product(pascal(), tried));
            const auto value = Unevenness(matrices, column + 1).value();
            if (value < least) ties = 0;
            if (value > least || random() % ++ties != 0) continue; // among equals, any
            least = value;
            best = tried;
        }
        std::printf("%u", least.first);
        std::fflush(stdout);
        order = best;
    }
    before.push_back(order);
    before.push_back(product(pascal(), order));
    return order;
}

void print_columns(const Matrix& order) {
    std::printf("\n");
    for (unsigned column = 0; column < columns; ++column) {
        std::uint32_t digits = 0;
        for (unsigned row = 0; row < columns; ++row) digits |= (order[row] >> column & 1u) << row;
        std::printf("0x%x%s", digits, column + 1 < columns ? ", " : "\n");
    }
}

} // namespace

int main(int argc, char** argv) {
    std::uint32_t seed = 1;
    CLI::App app{
        "Orders of Sobol points under which pairs of coordinates fill four and six dimensions evenly."};
    app.add_option("seed", seed, "of the columns that the search tries")->capture_default_str();
    app.footer(
        "Example, which printed the orders of src/render/sampling.cpp:\n  build/find_point_orders 226");
    CLI11_PARSE(app, argc, argv);
    std::mt19937 random(seed);
    Matrix identity{};
    for (unsigned row = 0; row < columns; ++row) identity[row] = 1u << row;
    std::vector<Matrix> matrices{identity, pascal()};
    for (const int dimensions : {4, 6}) {
        std::printf("t of 2, 4, 8, ... points in %d dimensions: ", dimensions);
        print_columns(add_pair(matrices, random));
    }
    return 0;
}
