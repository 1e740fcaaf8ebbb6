#include "server/open_browser.h"

#include <array>

#include <fcntl.h>
#include <spawn.h>
#include <unistd.h>

namespace marketgen::server {

bool open_browser(const std::string& address) {
  posix_spawnattr_t apart;
  posix_spawn_file_actions_t silent;
  if (posix_spawnattr_init(&apart) != 0) return false;
  posix_spawnattr_setflags(&apart, POSIX_SPAWN_SETSID);  // our Ctrl-C is not the browser's
  posix_spawn_file_actions_init(&silent);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&silent, stream, "/dev/null", O_RDWR, 0);
  std::string program = "xdg-open", url = address;
  const std::array<char*, 3> words{program.data(), url.data(), nullptr};
  pid_t child = 0;
  const int failed = posix_spawnp(&child, program.c_str(), &silent, &apart, words.data(), environ);
  posix_spawn_file_actions_destroy(&silent);
  posix_spawnattr_destroy(&apart);
  return failed == 0;
}

}  // namespace marketgen::server
