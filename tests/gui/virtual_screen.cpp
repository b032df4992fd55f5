#include "tests/gui/virtual_screen.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "tests/support/temporary_folder.h"

namespace {

constexpr int kPatience = 60'000;  // milliseconds for Xvfb to come up on a busy machine

[[noreturn]] void becomeXvfb(int numberTo, pid_t parent, const std::string& size) {
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(1);
  if (const int nowhere = open("/dev/null", O_WRONLY); nowhere >= 0) dup2(nowhere, STDERR_FILENO);
  const std::string descriptor = std::to_string(numberTo);
  execlp("Xvfb", "Xvfb", "-displayfd", descriptor.c_str(), "-screen", "0", size.c_str(), "-nolisten", "tcp",
         static_cast<char*>(nullptr));
  _exit(127);
}

// Xvfb picks a free number and writes it with the end of a line.
std::string readNumber(int from) {
  std::string number;
  pollfd ready{.fd = from, .events = POLLIN, .revents = 0};
  char byte = 0;
  while (poll(&ready, 1, kPatience) > 0 && read(from, &byte, 1) == 1) {
    if (byte == '\n') return number;
    number += byte;
  }
  return {};
}

}  // namespace

#ifdef __SANITIZE_ADDRESS__
// Libraries stay: leaks of an unloaded one have no name in the report, by which leaks.supp could know them.
extern "C" int dlclose(void*) noexcept {
  return 0;
}
#endif

bool startVirtualScreen(int width, int height) {
  int ends[2];
  if (pipe(ends) != 0) return false;
  fcntl(ends[0], F_SETFD, FD_CLOEXEC);
  const pid_t parent = getpid();
  const std::string size = std::to_string(width) + "x" + std::to_string(height) + "x24";
  if (fork() == 0) becomeXvfb(ends[1], parent, size);
  close(ends[1]);
  const std::string number = readNumber(ends[0]);
  close(ends[0]);
  if (number.empty()) {
    std::fputs("Xvfb did not start; it is in the Debian package xvfb\n", stderr);
    return false;
  }
  setenv("DISPLAY", (":" + number).c_str(), 1);
  setenv("QT_QPA_PLATFORM", "xcb", 1);
  for (const char* desktop : {"WAYLAND_DISPLAY", "XDG_CURRENT_DESKTOP", "QT_QPA_PLATFORMTHEME",
                              "QT_SCALE_FACTOR", "QT_STYLE_OVERRIDE", "XAUTHORITY"})
    unsetenv(desktop);
  return true;
}

void useEmptyHome() {
  static const TemporaryFolder home;
  setenv("HOME", home.path().c_str(), 1);
  for (const char* name :
       {"XDG_CONFIG_HOME", "XDG_CACHE_HOME", "XDG_DATA_HOME", "XDG_STATE_HOME", "XDG_RUNTIME_DIR"}) {
    const std::filesystem::path folder = home / name;
    std::filesystem::create_directory(folder);
    std::filesystem::permissions(folder, std::filesystem::perms::owner_all);
    setenv(name, folder.c_str(), 1);
  }
}
