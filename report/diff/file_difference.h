#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/image/image_difference.h"

namespace plumb {

/// What a comparison of two files came to.
enum class Sameness {
  identical,    ///< the same bytes, or the same pixels or numbers
  within,       ///< not visibly different; numbers within the tolerance
  different,    ///< beyond the tolerances, of another size, or other texts or bytes
  only_first,   ///< the second folder lacks it
  only_second,  ///< the first folder lacks it
  unreadable,   ///< one of them is damaged, too large, or no file
  not_compared  ///< there in both, of a kind that differs from run to run, or with nothing in it to compare
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
  bool pictures = false;  ///< keep those that differ, for a page
};

/// Two files of one name beside each other.
struct FileDifference {
  std::string name;  ///< within the folders
  Sameness sameness = Sameness::not_compared;
  double number = -1;    ///< greatest density (pictures) or relative difference (numbers); -1: none
  std::string in_words;  ///< with the numbers
  /// PNG files for the eye, where pictures differ and are asked for.
  std::string first, second, marks;
};

/// True if any of them fails.
bool differs(const std::vector<FileDifference>& files);

/// How many of them were compared, or are on one side only.
long compared(const std::vector<FileDifference>& files);

/// How files of a name are compared.
enum class Comparing { pictures, numbers, verdicts, bytes, nothing };
Comparing comparing(const std::string& name);

/// Compares two files by their bytes as their name says: pictures (.png) as they are seen, numbers (.csv),
/// the verdicts of a results.json, and others byte by byte, but for those of Plumb's that hold times and
/// paths. Errors name the files as `name_a` and `name_b`. Throws Interrupted.
FileDifference compare_files(const std::string& name, const std::string& a, const std::string& name_a,
                             const std::string& b, const std::string& name_b,
                             const DifferenceOptions& options);
/// The same of files that are called alike.
FileDifference compare_files(const std::string& name, const std::string& a, const std::string& b,
                             const DifferenceOptions& options);

/// What follows for a file that is compared by its bytes, or not at all.
FileDifference by_bytes(const std::string& name, bool same);

/// Compares two files, or all files of two folders, by path. Links to folders are not followed. Throws
/// InputError for what is not there, for a file beside a folder, and for single files that cannot be
/// compared; and Interrupted.
std::vector<FileDifference> compare_paths(const std::string& a, const std::string& b,
                                          const DifferenceOptions& options);

/// How one of the paths lies in the other: "A and B are the same file", "B lies in A"; empty: apart.
std::string overlap(const std::string& a, const std::string& b);

}  // namespace plumb
