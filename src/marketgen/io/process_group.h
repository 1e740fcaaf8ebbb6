// A program with everything that it starts: one group of processes that end together.
//
// A sentinel in the group listens to us. When this process ends, however it does (kill -9), the
// sentinel ends the group; so nothing that was started here goes on by itself, be it stuck or
// a child of the program's own. What leaves the group (setsid, setpgid, a daemon) is found by a
// variable of the environment that it inherited, and ends with the group, unless this process is
// killed or the variable is taken away (env -i). Ctrl-C on a terminal does not reach the group:
// whoever started it ends it. Not thread-safe.
#pragma once
#include <sys/types.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"

namespace marketgen::io {

class ProcessGroup {
 public:
  // `ends`: file descriptors that become the program's standard input, output and error; -1: ours.
  // `command[0]` is a path, or a name that is looked up in PATH; no shell is involved. Error
  // usage.unavailable.
  static Result<ProcessGroup> start(const std::vector<std::string>& command,
                                    const std::array<int, 3>& ends);
  ProcessGroup(ProcessGroup&& other) noexcept;
  ProcessGroup& operator=(ProcessGroup&&) = delete;
  ~ProcessGroup();  // ends it

  bool running() const { return program_ > 0; }  // end() has not been called
  bool is_over() const;                          // the program has ended by itself
  // Seconds of processor time that the program has used so far, on all its threads, with those of
  // its children that it has waited for; in steps of a hundredth. 0 after end().
  double cpu_s() const;
  // Ends what still runs of it and waits. The program's state as waitpid() tells it, and again that
  // when it is called again.
  int end();
  // Waits until the program has ended by itself, or so long, then end().
  int wait(double limit_s);

 private:
  ProcessGroup(pid_t sentinel, int lifeline) : sentinel_(sentinel), lifeline_(lifeline) {}

  pid_t sentinel_ = -1, program_ = -1;  // the group has the sentinel's number
  int lifeline_ = -1;                   // closed when this process ends
  int state_ = 0;
  std::string mark_;  // the variable
};

// "status 3" or "signal 9".
std::string end_of_program(int state);

// The two ends of a pipe, closed when they go; no program that is started inherits them.
class Pipe {
 public:
  Pipe();
  ~Pipe();
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  bool open() const { return open_; }
  int read_end() const { return ends_[0]; }
  int write_end() const { return ends_[1]; }
  void close_end(std::size_t end);  // 0 or 1
  int take_end(std::size_t end);    // from now on the caller's to close

 private:
  std::array<int, 2> ends_{-1, -1};
  bool open_ = false;
};

}  // namespace marketgen::io
