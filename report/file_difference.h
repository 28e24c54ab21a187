#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/image_difference.h"

namespace plumb {

/// What a comparison of two files came to.
enum class Sameness {
  identical,    ///< the same bytes, or the same pixels or numbers
  within,       ///< not visibly different; numbers within the tolerance
  different,    ///< beyond the tolerances, of another size, or other texts
  only_first,   ///< the second folder lacks it
  only_second,  ///< the first folder lacks it
  unreadable,   ///< one of them is damaged
  not_compared  ///< there in both, of a kind that differs from run to run
};

/// "identical", "not visibly different" or "within tolerance", "different", "missing", "new", "unreadable",
/// "not compared".
std::string word(Sameness);

/// True for those that a comparison fails by.
bool fails(Sameness);

/// What the user asked for. Without either knob, pictures with the same fingerprint must be the same to the
/// byte, and others are held to the defaults of DifferenceTolerance.
struct DifferenceOptions {
  std::optional<int> channel;
  std::optional<double> density;
  double numbers = 1e-9;  ///< of numbers, relative to the largest of their column
};

/// Two files of one name beside each other.
struct FileDifference {
  std::string name;  ///< within the folders
  Sameness sameness = Sameness::not_compared;
  double number = -1;    ///< greatest density (pictures) or relative difference (numbers); -1: none
  std::string in_words;  ///< with the numbers
  /// PNG files for the eye, where pictures differ.
  std::string first, second, marks;
};

/// Compares two PNG files (animated ones frame by frame) or two CSV files by their bytes. Other kinds are not
/// compared, but for the verdicts in results.json.
FileDifference compare_files(const std::string& name, const std::string& a, const std::string& b,
                             const DifferenceOptions& options);

/// Compares two files, or all files of two folders, by path. Throws InputError for what is not there, or for
/// a file beside a folder.
std::vector<FileDifference> compare_paths(const std::string& a, const std::string& b,
                                          const DifferenceOptions& options);

}  // namespace plumb
