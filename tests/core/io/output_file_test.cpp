#include "core/io/output_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "core/error.h"
#include "core/io/point_io.h"
#include "tests/support/temporary_folder.h"

namespace stipple {
namespace {

using testing::HasSubstr;

std::size_t filesIn(const std::filesystem::path& folder) {
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

template <class Action>
std::string ioErrorOf(Action action) {
  try {
    action();
  } catch (const IoError& error) {
    return error.what();
  }
  return {};
}

TEST(OutputFile, AppearsOnlyWhenCommitted) {
  const TemporaryFolder folder;
  {
    OutputFile file(folder / "a");
    file.write("new");
    EXPECT_FALSE(std::filesystem::exists(folder / "a"));
    file.commit();
  }
  EXPECT_EQ(contentOf(folder / "a"), "new");
  {
    OutputFile file(folder / "a");
    file.write("half of a newer");
  }
  EXPECT_EQ(contentOf(folder / "a"), "new");
  EXPECT_EQ(filesIn(folder.path()), 1u);
}

TEST(OutputFile, LargeWritesArriveInOrder) {
  const TemporaryFolder folder;
  std::string expected;
  OutputFile file(folder / "a");
  for (std::size_t length : {10u, 700000u, 700000u, 3000000u, 1u, 1048576u}) {
    const std::string part(length, static_cast<char>('a' + expected.size() % 26));
    file.write(part);
    expected += part;
  }
  file.commit();
  EXPECT_TRUE(contentOf(folder / "a") == expected);
}

TEST(OutputFile, KeepsTheModeAndFollowsLinks) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "there");
  setContent(folder / "there/real", "old");
  ::chmod((folder / "there/real").c_str(), 0640);
  std::filesystem::create_symlink("there/real", folder / "link");
  OutputFile file(folder / "link");
  file.write("new");
  file.commit();
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
  EXPECT_EQ(contentOf(folder / "there/real"), "new");
  struct stat status {};
  ::stat((folder / "there/real").c_str(), &status);
  EXPECT_EQ(status.st_mode & 07777, 0640u);
}

TEST(OutputFile, NewFilesHaveTheModeOfTheUmask) {
  const TemporaryFolder folder;
  const mode_t before = ::umask(027);
  OutputFile file(folder / "a");
  file.commit();
  ::umask(before);
  struct stat status {};
  ::stat((folder / "a").c_str(), &status);
  EXPECT_EQ(status.st_mode & 07777, 0640u);
}

TEST(OutputFile, PlacesThatCannotBeWrittenAreIoErrors) {
  const TemporaryFolder folder;
  EXPECT_THAT(ioErrorOf([&] { OutputFile file(folder / "no/such/folder/a.ply"); }),
              HasSubstr("No such file"));
  EXPECT_THAT(ioErrorOf([&] { OutputFile file(folder.path()); }), HasSubstr("directory"));
  EXPECT_THAT(ioErrorOf([&] {
                OutputFile file("/dev/full");
                file.write("text");
                file.commit();
              }),
              HasSubstr("/dev/full: cannot be written (No space left"));
}

PointSet manyPoints() {
  return PointSet(std::vector<Eigen::Vector3f>(100000, Eigen::Vector3f(1, 2, 3)));
}

// In a child process, because the limit on file sizes holds for the whole process.
TEST(OutputFile, AFullDiskKeepsTheOldFile) {
  const TemporaryFolder folder;
  setContent(folder / "a.ply", "old");
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{50000, 50000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    Progress progress;
    const std::string message = ioErrorOf([&] { writePoints(folder / "a.ply", manyPoints(), {}, progress); });
    ::_exit(message.find("a.ply: cannot be written (File too large)") != std::string::npos ? 0 : 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 0);
  EXPECT_EQ(contentOf(folder / "a.ply"), "old");
  EXPECT_EQ(filesIn(folder.path()), 1u);
}

// Dies without warning in the middle of writing.
class KilledHalfway : public Progress {
 public:
  void report(double fraction, std::string_view) override {
    if (fraction > 0.5) ::kill(::getpid(), SIGKILL);
  }
};

TEST(OutputFile, AKilledProcessLeavesTheOldFileWhole) {
  const TemporaryFolder folder;
  setContent(folder / "a.ply", "old");
  const pid_t child = ::fork();
  if (child == 0) {
    KilledHalfway progress;
    writePoints(folder / "a.ply", manyPoints(), {}, progress);
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(contentOf(folder / "a.ply"), "old");
}

}  // namespace
}  // namespace stipple
