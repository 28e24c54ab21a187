#include "report/program/history_file.h"

#include <sys/stat.h>

#include <thread>

#include "engine/base/errors.h"
#include "engine/base/file_writing.h"
#include "tests/report/program/program.h"

namespace plumb {
namespace history_file_test {

Document entry(int number) {
  Document made = entry_without_report("case", {}, std::string(3000, 'x'));
  made["steps"] = number;
  return made;
}

TEST(HistoryFile, IsEmptyWhereThereIsNone) {
  const TemporaryFolder folder;
  EXPECT_TRUE(read_history(folder / "none.jsonl").entries.empty());
  EXPECT_FALSE(fs::exists(folder / "none.jsonl"));
}

TEST(HistoryFile, OfManyWritersAtOnceHasEveryLineWhole) {
  const TemporaryFolder folder;
  const std::string path = folder / "h.jsonl";
  constexpr int writers = 6, lines = 10;
  {
    std::vector<std::jthread> threads;
    for (int w = 0; w < writers; ++w)
      threads.emplace_back([&, w] {
        for (int k = 0; k < lines; ++k) append_history(path, entry(w * lines + k));
      });
  }
  const History history = read_history(path);
  EXPECT_TRUE(history.damaged.empty()) << history.damaged.size();
  std::set<int> numbers;
  for (const Document& one : history.entries) numbers.insert(one.at("steps").get<int>());
  EXPECT_EQ(numbers.size(), std::size_t{writers * lines});
}

TEST(HistoryFile, OfALaterVersionIsRefusedAndStaysAsItIs) {
  const TemporaryFolder folder;
  const std::string path = folder / "h.jsonl",
                    text = history_line(entry(1)) + "{\"plumb_history\":9,\"x\":1}\n";
  write_text(path, text);
  try {
    read_history(path);
    ADD_FAILURE() << "it was read";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("line 2 is of version 9, this program knows 1"),
              std::string::npos)
        << error.what();
  }
  EXPECT_EQ(read_text(path), text);
}

TEST(HistoryFile, ThatCannotBeWrittenIsToldOfBeforeTheWork) {
  const TemporaryFolder folder;
  Console console(true, true);
  fs::create_symlink(folder.path() / "nowhere" / "h.jsonl", folder.path() / "link.jsonl");
  EXPECT_THROW(check_history(folder / "link.jsonl", console), WriteError);
  EXPECT_THROW(check_history(folder / "none/h.jsonl", console), WriteError);
  check_history(folder / "h.jsonl", console);
  EXPECT_FALSE(fs::exists(folder / "h.jsonl")) << "to look does not make it";
}

TEST(HistoryFile, TakesNoRunTwice) {
  const TemporaryFolder folder;
  for (const int number : {1, 2, 1, 2, 2}) append_history(folder / "h.jsonl", entry(number));
  EXPECT_EQ(read_history(folder / "h.jsonl").entries.size(), 2U);
}

TEST(HistoryFile, KeepsALineThatWasCutOffOnALineOfItsOwn) {
  const TemporaryFolder folder;
  const std::string path = folder / "h.jsonl", whole = history_line(entry(1)),
                    cut = whole.substr(0, whole.size() - 9);
  write_text(path, whole + cut);
  append_history(path, entry(2));
  EXPECT_TRUE(read_text(path) == whole + cut + "\n" + history_line(entry(2)));
  const History history = read_history(path);
  EXPECT_EQ(history.entries.size(), 2U);
  EXPECT_EQ(history.damaged, std::vector<std::size_t>{2});
}

TEST(HistoryFile, LeavesWhatIsNoHistoryAsItIs) {
  const TemporaryFolder folder;
  const auto expect_refused = [&](const std::string& path) {
    for (const bool writes : {false, true}) try {
        if (writes)
          append_history(path, entry(1));
        else
          read_history(path);
        ADD_FAILURE() << path << " was taken for a history";
      } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find(path), std::string::npos) << error.what();
      }
  };
  for (const std::string text : {"title = 3\n", "{}\n", "{", "\n", "[1]", "{\"plumb_other\":1}\n"}) {
    write_text(folder / "other.txt", text);
    expect_refused(folder / "other.txt");
    EXPECT_EQ(read_text(folder / "other.txt"), text);
  }
  ::mkfifo((folder / "pipe").c_str(), 0600);
  fs::create_directory(folder / "folder");
  for (const char* name : {"pipe", "folder"}) expect_refused(folder / name);
  EXPECT_THROW(append_history(folder / "none/h.jsonl", entry(1)), OutputError);
}

}  // namespace history_file_test
}  // namespace plumb
