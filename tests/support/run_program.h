// Starts the program under test and says what became of it.
#pragma once
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace marketgen {

// A folder of its own, removed with everything in it.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "marketgen-test-XXXXXX").string();
    if (mkdtemp(name.data()) != nullptr) path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline std::string contents_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

struct Ran {
  int status = -1;  // exit status; 128 + number when a signal ended it
  std::string out, err;
};

// A process of ours; its output goes to files, so that it never waits for a reader.
class Started {
 public:
  explicit Started(const std::vector<std::string>& command,
                   const std::filesystem::path& folder = {}) {
    const std::string out = (logs_.path() / "out").string(), err = (logs_.path() / "err").string();
    std::vector<char*> arguments;
    for (const std::string& word : command)
      arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    pid_ = fork();
    if (pid_ != 0) return;
    if (!folder.empty() && chdir(folder.c_str()) != 0) _exit(126);
    // Under nohup some are ignored, and so they would be by what is run.
    for (const int number : {SIGINT, SIGTERM, SIGHUP})
      signal(number, SIG_DFL);
    dup2(open("/dev/null", O_RDONLY), 0);
    dup2(open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), 1);
    dup2(open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), 2);
    execvp(arguments[0], arguments.data());
    _exit(127);
  }

  void interrupt() const { kill(pid_, SIGINT); }
  void send(int number) const { kill(pid_, number); }
  // Whether it has come so far that it handles the signal by itself.
  bool handles(int number) const {
    const std::string status = contents_of("/proc/" + std::to_string(pid_) + "/status");
    const std::size_t at = status.find("SigCgt:");
    if (at == std::string::npos) return false;
    const unsigned long long caught = std::stoull(status.substr(at + 7), nullptr, 16);
    return (caught >> static_cast<unsigned>(number - 1) & 1U) != 0;
  }
  void end_at_once() const { kill(pid_, SIGKILL); }  // kill -9
  std::string errors_so_far() const { return contents_of(logs_.path() / "err"); }
  std::string output_so_far() const { return contents_of(logs_.path() / "out"); }

  Ran wait() {
    int state = 0;
    waitpid(pid_, &state, 0);
    Ran ran;
    ran.status = WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state);
    ran.out = contents_of(logs_.path() / "out");
    ran.err = contents_of(logs_.path() / "err");
    return ran;
  }

 private:
  ScratchFolder logs_;
  pid_t pid_ = -1;
};

inline Ran run(const std::vector<std::string>& command, const std::filesystem::path& folder = {}) {
  return Started(command, folder).wait();
}

// `marketgen` with these arguments.
inline Ran marketgen_run(std::vector<std::string> arguments,
                         const std::filesystem::path& folder = {}) {
  arguments.insert(arguments.begin(), MARKETGEN_BINARY);
  return run(arguments, folder);
}

}  // namespace marketgen
