#include "app/plugins/loader.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>

namespace stipple {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class Loader : public testing::Test {
 protected:
  Loader() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() / ("stipple_loader_" + std::to_string(getpid()) + test->name());
    fs::create_directories(folder_);
  }
  ~Loader() override { fs::remove_all(folder_); }

  void put(const std::string& plugin) {
    const fs::path built = fs::path(STIPPLE_BINARY_DIR) / "tests";
    const fs::path folder = plugin == "operators" ? built / "good_plugins" : built / "odd_plugins";
    fs::copy_file(folder / (plugin + ".so"), folder_ / (plugin + ".so"));
  }
  LoadedPlugins load() const { return loadPlugins({folder_}); }
  // The only warning when `plugin` is loaded beside a good one, which must be there unharmed.
  std::string refusalOf(const std::string& plugin) {
    put("operators");
    put(plugin);
    const LoadedPlugins loaded = load();
    EXPECT_NE(loaded.registry.find("stepper"), nullptr);
    EXPECT_EQ(loaded.registry.operators().size(), 5u);
    EXPECT_EQ(loaded.warnings.size(), 1u);
    return loaded.warnings.empty() ? "" : loaded.warnings.front();
  }

  fs::path folder_;
};

TEST_F(Loader, OperatorsComeAndGoWithTheFile) {
  put("operators");
  EXPECT_NE(load().registry.find("stepper"), nullptr);
  EXPECT_THAT(load().warnings, IsEmpty());
  fs::remove(folder_ / "operators.so");
  EXPECT_THAT(load().registry.operators(), IsEmpty());
  EXPECT_THAT(load().warnings, IsEmpty());
}

TEST_F(Loader, AFolderThatIsNotThereHoldsNothing) {
  EXPECT_THAT(loadPlugins({folder_ / "absent"}).warnings, IsEmpty());
}

TEST_F(Loader, RefusesATextFile) {
  put("operators");
  std::ofstream(folder_ / "notes.so") << "not a library\n";
  std::ofstream(folder_ / ".hidden") << "passed over\n";
  const LoadedPlugins loaded = load();
  EXPECT_NE(loaded.registry.find("stepper"), nullptr);
  EXPECT_THAT(loaded.warnings, ElementsAre(AllOf(HasSubstr("notes.so"), HasSubstr("not a shared library"))));
}

TEST_F(Loader, RefusesATruncatedLibrary) {
  put("operators");
  std::ofstream(folder_ / "cut.so", std::ios::binary) << "\x7f"
                                                         "ELF\x02\x01\x01";
  const LoadedPlugins loaded = load();
  EXPECT_EQ(loaded.registry.operators().size(), 5u);
  EXPECT_THAT(loaded.warnings, ElementsAre(AllOf(HasSubstr("cut.so"), HasSubstr("cannot be loaded"))));
}

TEST_F(Loader, RefusesAnotherInterfaceVersion) {
  EXPECT_THAT(refusalOf("other_version"),
              AllOf(HasSubstr("other_version.so"), HasSubstr("version 99"), HasSubstr("version 1")));
}

TEST_F(Loader, RefusesAnotherCompiler) {
  EXPECT_THAT(refusalOf("other_compiler"), AllOf(HasSubstr("other_compiler.so"), HasSubstr("GCC 999")));
}

TEST_F(Loader, RefusesAnotherMagic) {
  EXPECT_THAT(refusalOf("other_magic"), HasSubstr("magic"));
}

TEST_F(Loader, RefusesALibraryWithoutTheSymbols) {
  EXPECT_THAT(refusalOf("no_header"), HasSubstr("no symbol stipple_plugin_header"));
}

TEST_F(Loader, RefusesAHeaderWithoutARegisterFunction) {
  EXPECT_THAT(refusalOf("no_registration"), HasSubstr("no symbol stipple_plugin_register"));
}

TEST_F(Loader, RefusesWhatCannotBeLinked) {
  EXPECT_THAT(refusalOf("undefined_symbol"),
              AllOf(HasSubstr("functionThatNoLibraryHas"), Not(HasSubstr("\n"))));
}

TEST_F(Loader, APluginThatThrowsAddsNothing) {
  EXPECT_THAT(refusalOf("throwing"), AllOf(HasSubstr("throwing.so"), HasSubstr("no license for Tuesdays")));
}

TEST_F(Loader, TheSecondWithTheSameOperatorIdIsRefusedWhole) {
  put("another_stepper");
  put("operators");
  const LoadedPlugins loaded = load();
  EXPECT_NE(loaded.registry.find("free"), nullptr);
  EXPECT_EQ(loaded.registry.find("thin_out"), nullptr);
  EXPECT_THAT(loaded.warnings, ElementsAre(AllOf(HasSubstr("operators.so"), HasSubstr("'stepper'"))));
}

TEST_F(Loader, LooksBesideTheProgramAndInTheNamedFolders) {
  setenv("STIPPLE_PLUGIN_PATH", "/one:/two", 1);
  const auto folders = pluginFolders();
  unsetenv("STIPPLE_PLUGIN_PATH");
  ASSERT_EQ(folders.size(), 3u);
  EXPECT_THAT(folders[0].string(), testing::StartsWith(STIPPLE_BINARY_DIR));
  EXPECT_EQ(folders[1], "/one");
  EXPECT_EQ(folders[2], "/two");
}

}  // namespace
}  // namespace stipple
