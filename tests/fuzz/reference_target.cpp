#include "tests/fuzz/small_files.h"

namespace plumb::fuzz {
namespace {

bool feed(std::string_view input) {
  return reads<InputError>([&] {
    const Reference read = read_reference({"reference.toml", std::string(input)});
    promise(!read.times.empty() && !read.series.empty(), "a reference of nothing");
    promise_finite(read.times, "a time");
    promise(read.times.front() >= 0, "a time before 0");
    for (std::size_t k = 1; k < read.times.size(); ++k)
      promise(read.times[k] > read.times[k - 1], "times that do not rise");
    promise(!read.source.empty() && !read.obtained.empty(), "a reference without its source");
    for (const ReferenceSeries& series : read.series) {
      promise(series.values.size() == read.times.size(), "values beside no time");
      promise_finite(series.values, series.name);
      promise(std::isfinite(series.uncertainty) && series.uncertainty > 0, "an uncertainty of nothing");
      promise(read.find(series.name) == &series, "two series of one name");
    }
  });
}

}  // namespace

const Target reference_target{"reference", feed, reference_texts};

}  // namespace plumb::fuzz
