#include <memory>
#include <stdexcept>

#include "engine/base/hdf5.h"
#include "engine/base/hdf5_library_reader.h"
#include "engine/base/packed.h"

namespace plumb::hdf5 {
namespace {

enum class Ask : std::uint64_t {
  open,
  has,
  numbers,
  shaped_numbers,
  integers,
  texts,
  bytes,
  series,
  series_values,
  unit
};

std::string question(Ask what, const std::string& path = {}, const std::vector<hsize_t>& shape = {}) {
  return Packed().add(static_cast<std::uint64_t>(what)).add(path).add(shape).take();
}

std::string answer(const LibraryReader& file, const std::string& question) {
  Unpacked asked(question);
  const auto what = static_cast<Ask>(asked.number());
  const std::string path = asked.text();
  const auto shape = asked.numbers<hsize_t>();
  Packed packed;
  switch (what) {
    case Ask::open:
      break;
    case Ask::has:
      packed.add(file.has(path) ? 1U : 0U);
      break;
    case Ask::numbers: {
      const Numbers numbers = file.numbers(path);
      packed.add(numbers.shape).add(numbers.values);
      break;
    }
    case Ask::shaped_numbers:
      packed.add(file.numbers(path, shape));
      break;
    case Ask::integers:
      packed.add(file.integers(path));
      break;
    case Ask::texts:
      packed.add(file.texts(path));
      break;
    case Ask::bytes:
      packed.add(file.bytes(path));
      break;
    case Ask::series:
      packed.add(file.series());
      break;
    case Ask::series_values:
      packed.add(file.series_values(path, shape.at(0)));
      break;
    case Ask::unit:
      packed.add(file.unit(path));
      break;
  }
  return packed.take();
}

Confinement limits_for(std::size_t size) {
  constexpr std::uint64_t mebibyte = 1024 * 1024;
  // The library holds the file several times over, and what it was asked for.
  return {512 * mebibyte + 6 * size, static_cast<int>(2 + size / (200 * mebibyte)),
          256 * mebibyte + 2 * size};
}

/// Opens the file with the first question, when the limits hold.
ConfinedProcess::Answer answers_from(const std::string& bytes) {
  return [&bytes, file = std::shared_ptr<LibraryReader>()](const std::string& question) mutable {
    if (!file) file = std::make_shared<LibraryReader>(bytes);
    return answer(*file, question);
  };
}

template <class Value>
Value only(std::vector<Value> all, const std::string& path, const char* what) {
  if (all.size() != 1) throw std::runtime_error("the data set " + path + " is not one " + what);
  return std::move(all.front());
}

}  // namespace

Reader::Reader(const std::string& bytes) : process_(limits_for(bytes.size()), answers_from(bytes)) {
  process_.ask(question(Ask::open));
}

bool Reader::has(const std::string& path) const {
  const std::string packed = process_.ask(question(Ask::has, path));
  return Unpacked(packed).number() != 0;
}

Numbers Reader::numbers(const std::string& path) const {
  const std::string packed = process_.ask(question(Ask::numbers, path));
  Unpacked unpacked(packed);
  Numbers result{unpacked.numbers<hsize_t>(), {}};
  result.values = unpacked.numbers<double>();
  return result;
}

std::vector<double> Reader::numbers(const std::string& path, const std::vector<hsize_t>& shape) const {
  const std::string packed = process_.ask(question(Ask::shaped_numbers, path, shape));
  std::vector<double> values = Unpacked(packed).numbers<double>();
  hsize_t count = 1;
  for (const hsize_t extent : shape) count *= extent;
  if (values.size() != count) throw std::runtime_error("it is damaged or hostile (half a data set)");
  return values;
}

double Reader::number(const std::string& path) const {
  return only(numbers(path).values, path, "number");
}

std::vector<long> Reader::integers(const std::string& path) const {
  const std::string packed = process_.ask(question(Ask::integers, path));
  return Unpacked(packed).numbers<long>();
}

long Reader::integer(const std::string& path) const {
  return only(integers(path), path, "number");
}

std::vector<std::string> Reader::texts(const std::string& path) const {
  const std::string packed = process_.ask(question(Ask::texts, path));
  return Unpacked(packed).texts();
}

std::string Reader::text(const std::string& path) const {
  return only(texts(path), path, "text");
}

std::string Reader::bytes(const std::string& path) const {
  const std::string packed = process_.ask(question(Ask::bytes, path));
  return Unpacked(packed).text();
}

std::vector<std::string> Reader::series() const {
  const std::string packed = process_.ask(question(Ask::series));
  return Unpacked(packed).texts();
}

std::vector<double> Reader::series_values(const std::string& path, hsize_t most) const {
  const std::string packed = process_.ask(question(Ask::series_values, path, {most}));
  return Unpacked(packed).numbers<double>();
}

std::string Reader::unit(const std::string& path) const {
  const std::string packed = process_.ask(question(Ask::unit, path));
  return Unpacked(packed).text();
}

}  // namespace plumb::hdf5
