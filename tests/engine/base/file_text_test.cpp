#include "engine/base/file_text.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace plumb {
namespace file_text_test {

namespace fs = std::filesystem;

class FileTextTest : public testing::Test {
 protected:
  FileTextTest() {
    std::string name = (fs::temp_directory_path() / "plumb-test-XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
  }
  ~FileTextTest() override { fs::remove_all(folder_); }
  std::string path(const char* name) const { return (folder_ / name).string(); }

 private:
  fs::path folder_;
};

TEST_F(FileTextTest, IsThatOfARegularFile) {
  const std::string text(3'000'000, 'x');
  std::ofstream(path("a")) << text;
  const FileText read = read_file_text(path("a"));
  EXPECT_EQ(read.failure, "");
  EXPECT_EQ(read.text == text, true);
}

TEST_F(FileTextTest, IsRefusedAtOnceForAllThatIsNoRegularFile) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  EXPECT_EQ(read_file_text(path("pipe")).failure, "it is a named pipe; only regular files are read");
  EXPECT_EQ(read_file_text("/dev/zero").failure, "it is a device; only regular files are read");
  EXPECT_EQ(read_file_text(path("")).failure, "Is a directory");
  const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  path("socket").copy(address.sun_path, sizeof address.sun_path - 1);
  ASSERT_EQ(::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  ::close(socket);
  EXPECT_EQ(read_file_text(path("socket")).failure, "it is a socket; only regular files are read");
  EXPECT_EQ(read_file_text(path("none")).failure, "No such file or directory");
  EXPECT_EQ(read_file_text(std::string("a\0b", 3)).failure, "its name holds a 0 byte");
}

TEST_F(FileTextTest, IsRefusedWhereTheFileSaysThatItIsEmptyAndIsNot) {
  EXPECT_EQ(read_file_text("/proc/self/status").failure,
            "it has no length of its own, as a file of the system");
}

TEST_F(FileTextTest, IsRefusedBeyondTheLengthOfItsKindWithoutReadingIt) {
  std::ofstream(path("a")) << "x";
  for (const InputKind kind : {InputKind::case_file, InputKind::reference, InputKind::given_run,
                               InputKind::document, InputKind::picture, InputKind::run_file}) {
    fs::resize_file(path("a"), longest(kind) + 1);
    const FileText read = read_file_text(path("a"), kind);
    EXPECT_TRUE(read.failure.starts_with("it is longer than ")) << longest(kind) << ": " << read.failure;
  }
}

}  // namespace file_text_test
}  // namespace plumb
