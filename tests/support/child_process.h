// Another program, started by a test and killed when this goes.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <string>
#include <vector>

namespace accord::testing {

class ChildProcess {
 public:
  // command: the program's path, then its arguments.
  explicit ChildProcess(std::vector<std::string> command) : child_(fork()) {
    if (child_ != 0) return;
    std::vector<char*> words;
    for (std::string& word : command) words.push_back(word.data());
    words.push_back(nullptr);
    execv(words[0], words.data());
    _exit(127);
  }
  ~ChildProcess() {
    if (child_ > 0) {
      signal(SIGKILL);
      wait();
    }
  }
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  pid_t id() const { return child_; }
  void signal(int number) const { kill(child_, number); }
  // Its status, as waitpid() tells it.
  int wait() {
    int status = 0;
    waitpid(child_, &status, 0);
    child_ = 0;
    return status;
  }

 private:
  pid_t child_;
};

}  // namespace accord::testing
