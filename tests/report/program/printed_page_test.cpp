#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/report/program/program.h"

namespace plumb {
namespace printed_page_test {

/// A finished run with small pictures.
class PrintedPage : public ::testing::Test {
 protected:
  PrintedPage() {
    const fs::path data = fs::path(PLUMB_SOURCE_DIR) / "tests/data";
    write_text(folder_ / "small_reference.toml", read_text(data / "small_reference.toml"));
    std::string text = read_text(data / "small_case.toml");
    for (const auto& [from, to] :
         {std::pair<std::string, std::string>{"size = [640, 480]", "size = [64, 48]"},
          {"frame_rate = 10", "frame_rate = 1"}})
      text.replace(text.find(from), from.size(), to);
    write_text(folder_ / "one.toml", text);
    plumb_in(folder_.path(), {"run", "one.toml", "-o", "run"});
  }

  /// The same program where PATH finds only what lies in these folders.
  Ended report_with_path(const std::string& path, const std::vector<std::string>& more) {
    std::vector<std::string> command{"/usr/bin/env", "PATH=" + path, PLUMB_PROGRAM, "report"};
    command.insert(command.end(), more.begin(), more.end());
    return run_command(command, folder_.path());
  }

  /// A stand-in for Chromium that does this with its arguments.
  std::string browser_that(const std::string& does) {
    write_text(folder_ / "bin/chromium", "#!/bin/sh\n" + does + "\n");
    fs::permissions(folder_ / "bin/chromium", fs::perms::owner_all);
    return (folder_ / "bin").string() + ":/usr/bin:/bin";
  }

  TemporaryFolder folder_;
};

TEST_F(PrintedPage, WithoutABrowserIsRefusedBeforeAnythingIsDone) {
  const std::string before = read_text(folder_ / "run/index.html");
  fs::last_write_time(folder_ / "run/index.html", fs::file_time_type{});
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"run", "--pdf"},
                                                    {"--from", "run/results.json", "--pdf"},
                                                    {"run", "run", "--pdf"}}) {
    const Ended ended = report_with_path("/nowhere", arguments);
    EXPECT_EQ(ended.status, 5) << ended.err;
    expect_one_line(ended.err);
    for (const char* named : {"report.pdf", "chromium", "chromium-browser", "google-chrome"})
      EXPECT_NE(ended.err.find(named), std::string::npos) << ended.err;
  }
  EXPECT_EQ(fs::last_write_time(folder_ / "run/index.html"), fs::file_time_type{});
  EXPECT_FALSE(fs::exists(folder_ / "run/report.pdf"));
}

TEST_F(PrintedPage, ThatTheBrowserDoesNotPrintWholeLeavesTheFolderAsItWas) {
  const std::string whole_name = "for a in \"$@\"; do case $a in --print-to-pdf=*) f=${a#*=};; esac; done; ";
  const std::string manifest = read_text(folder_ / "run/manifest.json");
  for (const std::string& does :
       {std::string("exit 1"), std::string("exit 0"), whole_name + "printf '%%PDF-1.4' > \"$f\"",
        whole_name + "printf 'no PDF %%%%EOF' > \"$f\"",
        whole_name + "printf '%%PDF-1.4 %%%%EOF' > \"$f\"; exit 1"}) {
    const Ended ended = report_with_path(browser_that(does), {"--from", "run/results.json", "--pdf"});
    EXPECT_EQ(ended.status, 5) << does << ": " << ended.err;
    expect_one_line(ended.err);
    EXPECT_EQ(read_text(folder_ / "run/manifest.json"), manifest) << does;
    EXPECT_FALSE(fs::exists(folder_ / "run/report.pdf")) << does;
  }
}

TEST_F(PrintedPage, IsInTheFolderAndItsManifest) {
  const std::string path = browser_that(
      "for a in \"$@\"; do case $a in --print-to-pdf=*) f=${a#*=};; file://*) p=${a#file://};; esac; done; "
      "grep -q '<h1>' \"$p\" && printf '%%PDF-1.4 %%%%EOF' > \"$f\"");
  ASSERT_LE(report_with_path(path, {"run", "--pdf"}).status, 1);
  EXPECT_EQ(read_text(folder_ / "run/report.pdf"), "%PDF-1.4 %%EOF") << "printed from the page";
  const auto manifest = nlohmann::json::parse(read_text(folder_ / "run/manifest.json"));
  EXPECT_NE(manifest.dump().find("report.pdf"), std::string::npos) << manifest;
  // A report without it has none of an earlier one.
  ASSERT_LE(report_with_path(path, {"run"}).status, 1);
  EXPECT_FALSE(fs::exists(folder_ / "run/report.pdf"));
}

TEST_F(PrintedPage, IsAPdfWhereChromiumIsThere) {
  if (run_command({"/bin/sh", "-c", "command -v chromium chromium-browser google-chrome"}, folder_.path())
          .out.empty())
    GTEST_SKIP() << "none of chromium, chromium-browser and google-chrome is installed";
  const Ended ended = plumb_in(folder_.path(), {"report", "--from", "run/results.json", "--pdf"});
  ASSERT_LE(ended.status, 1) << ended.err;
  const std::string pdf = read_text(folder_ / "run/report.pdf");
  EXPECT_TRUE(pdf.starts_with("%PDF-")) << pdf.substr(0, 20);
  EXPECT_GT(pdf.size(), 20000U);
}

}  // namespace printed_page_test
}  // namespace plumb
