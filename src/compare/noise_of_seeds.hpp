#pragma once
// Standard errors of a picture, from pictures of it with other seeds.
#include "image/image.hpp"

#include <string>
#include <vector>

namespace sr::compare {

/// Gathers pictures of one view, one a seed.
class NoiseOfSeeds {
public:
    /// @throws Error if the picture has another size or other channels than the first, or no colours
    void add(const image::Image& picture);

    /// The standard errors of one picture, of all its channels: of each pixel, of the mean over the block of
    /// 16×16 pixels around it ("block."), and of the mean over the picture ("whole."). Neighbours may err
    /// alike, since all pixels can share the places of their samples: the errors of sums do not follow from
    /// those of pixels. The attribute "steradian:seeds" is the number of pictures.
    ///
    /// Where the pictures state their number of samples ("steradian:samples"), a pixel's error is no less
    /// than that of a sample that may fall to the other side of an edge, though it did in no picture: it
    /// changes the pixel by 1/samples of the range of the 3×3 around it, with the chance 1 / (pictures + 2)
    /// (Laplace's rule of succession). @throws Error for fewer than two
    image::Image errors() const;

private:
    struct Moments {
        std::vector<double> mean;
        std::vector<double> squares;                            // of the distance from the mean
        void add(const std::vector<double>& values, int count); // Welford 1962
    };
    /// Returns the least error of a channel of a pixel.
    double unseen_error(std::size_t pixel, std::size_t channel) const;
    std::vector<double> unseen_errors() const; // of all pixels, channels one by one

    int width_ = 0;
    int height_ = 0;
    double samples_ = 0.0;           // of a pixel of the first picture; 0: not stated
    std::vector<std::string> names_; // of the channels
    int count_ = 0;
    Moments pixels_;
    Moments blocks_; // means, row by row
    Moments whole_;
};

} // namespace sr::compare
