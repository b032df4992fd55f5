#include "app/plugins/sentinel.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "app/plugins/loader.h"
#include "tests/support/temporary_folder.h"

namespace stipple {
namespace {

// A program that is killed while the plugin is at work.
void breakDownWith(const std::filesystem::path& folder, const std::filesystem::path& plugin) {
  const pid_t child = ::fork();
  if (child == 0) {
    PluginSentinel sentinel(folder);
    const auto watch = sentinel.watch(plugin);
    ::kill(::getpid(), SIGKILL);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status));
}

TEST(PluginSentinel, APluginThatWasAtWorkAtABreakdownIsOffUntilTurnedOn) {
  const TemporaryFolder folder;
  breakDownWith(folder.path(), "/plugins/wild.so");
  PluginSentinel next(folder.path());
  EXPECT_TRUE(next.isOff("/plugins/wild.so"));
  EXPECT_FALSE(next.isOff("/plugins/tame.so"));
  EXPECT_TRUE(PluginSentinel(folder.path()).isOff("/plugins/wild.so")) << "it stays off";
  next.turnOnAll();
  EXPECT_FALSE(PluginSentinel(folder.path()).isOff("/plugins/wild.so"));
}

TEST(PluginSentinel, WhatEndedInOrderOrStillRunsStaysOn) {
  const TemporaryFolder folder;
  PluginSentinel first(folder.path());
  first.watch("/plugins/done.so").reset();
  const auto atWork = first.watch("/plugins/busy.so");
  const PluginSentinel second(folder.path());
  EXPECT_FALSE(second.isOff("/plugins/done.so"));
  EXPECT_FALSE(second.isOff("/plugins/busy.so")) << "another program is at it";
}

TEST(PluginSentinel, AFolderThatCannotBeWrittenHarmsNothing) {
  PluginSentinel sentinel("/proc/none");
  const auto watch = sentinel.watch("/plugins/any.so");
  EXPECT_NE(watch, nullptr);
  EXPECT_FALSE(sentinel.isOff("/plugins/any.so"));
}

TEST(PluginSentinel, PluginsThatAreOffAreLeftOutWithASentence) {
  const TemporaryFolder folder, state;
  const auto plugins = pluginFolders();
  LoadedPlugins all = loadPlugins(plugins);
  ASSERT_TRUE(all.files.contains("classifier")) << "the plugins of the build";
  breakDownWith(state.path(), all.files.at("classifier"));
  PluginSentinel sentinel(state.path());
  const LoadedPlugins rest = loadPlugins(plugins, &sentinel);
  EXPECT_EQ(rest.registry.find("classifier"), nullptr);
  EXPECT_NE(rest.registry.find("segmentation"), nullptr);
  ASSERT_EQ(rest.warnings.size(), all.warnings.size() + 1);
}

}  // namespace
}  // namespace stipple
