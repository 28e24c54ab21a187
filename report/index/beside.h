#pragma once

#include <string>
#include <vector>

#include "report/document/document.h"

namespace plumb {

/// A picture that two reports have.
struct PicturePair {
  std::string title;
  std::string first, second;  ///< PNG
};

/// Whether times rise from each to the next, without which nothing can be interpolated.
bool is_rising(const std::vector<double>& times);

/// What an index of two reports has of them beside one another.
struct Beside {
  Document document = {};  ///< beside_of(); null: there are not two
  std::vector<PicturePair> pictures = {};
};

/// Two reports beside one another, `beside` of an index: `first` and `second` are what they are called, and
/// what they have in common has its value in each and the difference, second minus first: `verdicts[]`,
/// `numbers[]` of the computation, and `probes[]` with their greatest distance, where times differ by
/// interpolation. `case[]` is what the cases differ in, `not_compared[]` what cannot be compared and why,
/// `headline` all of it in a sentence or two.
Document beside_of(const Document& first, const std::string& first_name, const Document& second,
                   const std::string& second_name);

/// The same as a section of a page, with `curves`, HTML, and the pictures to slide over one another, as many
/// as have room in `room` bytes.
std::string beside_html(const Document& beside, const std::string& curves,
                        const std::vector<PicturePair>& pairs, std::size_t room);

}  // namespace plumb
