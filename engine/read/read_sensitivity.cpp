#include <algorithm>

#include "engine/case/blunder_words.h"
#include "engine/read/case_sections.h"
#include "engine/read/model_numbers.h"

namespace plumb {

SensitivitySpec read_sensitivity(TableReader table, const Case& spec) {
  SensitivitySpec read = default_sensitivity(spec);
  const std::vector<std::string> known = read.numbers;
  const auto no_twice = [&](const char* key, std::vector<std::size_t> places) {
    std::sort(places.begin(), places.end());
    if (std::adjacent_find(places.begin(), places.end()) != places.end())
      table.refuse_value(key, "must not name the same twice");
    return places;
  };
  if (const auto places = table.choices("numbers", known)) {
    read.numbers.clear();
    for (const std::size_t place : no_twice("numbers", *places)) read.numbers.push_back(known[place]);
  }
  std::vector<std::string> words;
  for (const Blunder blunder : read.blunders) words.emplace_back(word(blunder));
  if (const auto places = table.choices("blunders", words)) {
    read.blunders.clear();
    for (const std::size_t place : no_twice("blunders", *places))
      read.blunders.push_back(words_of<Blunder>[place].value);
  }
  table.read(read);
  table.finish();
  return read;
}

SensitivitySpec default_sensitivity(const Case& spec) {
  SensitivitySpec all{.numbers = {}, .blunders = enum_values(Blunder()), .largest = 100, .time_limit = 10};
  for (ModelNumber& number : model_numbers(spec)) all.numbers.push_back(std::move(number.key));
  return all;
}

}  // namespace plumb
