#pragma once
// Accessors: numbers of any component type, strided, normalised or sparse, as floats or indices.
// glTF 2.0 specification, section 3.6.2; integers as fractions: section 3.11.
#include "core/math.hpp"
#include "gltf/document.hpp"

namespace sr::gltf {

/// Returns the number of its elements.
std::size_t count_of(const Document& document, int accessor);

/// Returns the number of components of an element: 1 to 4, 16 for a MAT4.
int components_of(const Document& document, int accessor);

/// The components of all elements, one element after the other; those of a matrix column by column.
/// Errors as of vectors().
std::vector<float> numbers(const Document& document, int accessor);

/// All elements as vectors of N floats. Without a buffer view they are zeros, before sparse values replace
/// some.
/// @throws Error if it has another number of components, or reaches beyond its buffer view
template<int N>
std::vector<glm::vec<N, float>> vectors(const Document& document, int accessor);

/// All elements as unsigned integers. @throws Error as above, and if they are not unsigned integers
std::vector<std::uint32_t> indices(const Document& document, int accessor);

/// The index that restarts a strip in other APIs and that glTF forbids: the largest of the component type.
std::uint32_t restart_index(const Document& document, int accessor);

} // namespace sr::gltf
