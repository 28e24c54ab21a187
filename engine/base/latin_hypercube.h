#pragma once

#include <cstdint>
#include <vector>

namespace plumb {

/// A Latin hypercube: `samples` points in the unit cube of `dimensions`, each coordinate with one point in
/// each of `samples` equal strata, at random within it and in random order (McKay, Beckman and Conover 1979,
/// Technometrics 21, 239). The same for the same arguments on every machine. Numbers in (0, 1), a row a
/// sample.
std::vector<std::vector<double>> latin_hypercube(std::size_t samples, std::size_t dimensions,
                                                 std::uint64_t seed);

/// The value that a standard normal variable stays below with probability p in (0, 1), to some 1e-15 of it.
double normal_quantile(double p);

}  // namespace plumb
