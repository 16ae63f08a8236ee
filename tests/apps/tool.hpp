#pragma once

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "io/temporary_folder.hpp"

namespace scanfuse::tool_testing {

using io_testing::content_of;
using io_testing::TemporaryFolder;

struct Outcome {
  int code = -1;  ///< -1: ended by a signal
  std::string out, err;
};

/// Runs the tool as a shell would, output and errors apart.
inline Outcome run_tool(const TemporaryFolder& folder, const std::string& arguments) {
  const auto out = folder.path() / "stdout", err = folder.path() / "stderr";
  const std::string command =
      std::string(SCANFUSE_TOOL) + " " + arguments + " >" + out.string() + " 2>" + err.string();
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content_of(out), content_of(err)};
}

/// Starts the tool, waits until `sign_of_life` has grown to a size, and presses Ctrl-C. The exit
/// code; -1 when it ended otherwise.
inline int interrupt_tool(std::vector<std::string> arguments,
                          const std::filesystem::path& sign_of_life) {
  arguments.insert(arguments.begin(), SCANFUSE_TOOL);
  std::vector<char*> argv;
  for (auto& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  const pid_t child = ::fork();
  if (child == 0) {
    const int nowhere = ::open("/dev/null", O_WRONLY);
    ::dup2(nowhere, STDOUT_FILENO);
    ::dup2(nowhere, STDERR_FILENO);
    ::execv(argv[0], argv.data());
    ::_exit(127);
  }
  int status = 0;
  for (int i = 0; i < 1000 && ::waitpid(child, &status, WNOHANG) == 0; ++i) {
    std::error_code missing;
    const auto size = std::filesystem::file_size(sign_of_life, missing);
    if (!missing && size > 0) {
      ::kill(child, SIGINT);
      ::waitpid(child, &status, 0);
      return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  ::kill(child, SIGKILL);
  return -1;
}

/// Names of the files in a folder that end in ".part": what is not whole.
inline std::vector<std::string> unfinished_files(const TemporaryFolder& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    if (entry.path().extension() == ".part") names.push_back(entry.path().filename());
  }
  return names;
}

}  // namespace scanfuse::tool_testing
