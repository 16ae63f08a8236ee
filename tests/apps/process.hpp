#pragma once

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "io/temporary_folder.hpp"

namespace scanfuse::tool_testing {

/// A program that runs beside the test, the tool itself where only arguments are given; what it
/// says goes to a file. Killed with its owner.
class Process {
 public:
  Process(std::vector<std::string> arguments, const std::filesystem::path& errors)
      : Process(SCANFUSE_TOOL, std::move(arguments), errors) {}
  Process(const std::string& program, std::vector<std::string> arguments,
          const std::filesystem::path& errors) {
    arguments.insert(arguments.begin(), program);
    std::vector<char*> argv;
    for (auto& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    child_ = ::fork();
    if (child_ != 0) return;
    const int file = ::open(errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    ::dup2(file, STDERR_FILENO);
    ::dup2(file, STDOUT_FILENO);
    ::execv(argv[0], argv.data());
    ::_exit(127);
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  ~Process() { end(SIGKILL); }
  /// Its exit code when it ends by itself; -1 when a signal ended it.
  int wait() { return end(0); }
  /// Its exit code; -1 when a signal ended it.
  int end(int signal) {
    if (child_ <= 0) return -1;
    ::kill(child_, signal);
    int status = 0;
    ::waitpid(child_, &status, 0);
    child_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  pid_t child_ = -1;
};

/// Plays a device until destroyed; `address` is where it was told to be found.
class Player {
 public:
  Player(const TemporaryFolder& folder, const std::string& device)
      : said_(folder.path() / (device + ".err")),
        process_({"simulate", "road-users", "--serve", device + ":0"}, said_) {
    for (int i = 0; i < 1000 && address.empty(); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      const std::string text = content_of(said_);
      const auto at = text.find("serving ");
      if (at == std::string::npos || text.find('\n', at) == std::string::npos) continue;
      address = text.substr(at + 8, text.find('\n', at) - at - 8);
    }
  }
  std::string address;

 private:
  std::filesystem::path said_;
  Process process_;
};

}  // namespace scanfuse::tool_testing
