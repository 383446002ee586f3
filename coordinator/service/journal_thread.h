// A thread of the journal's own, beside the coordinator's loop: a write waits for the disk, some
// milliseconds each, and the loop must not. What is asked for while it waits is written together.
//
// Everything here is for the loop, but the journal, which is the thread's from now on.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <tl/expected.hpp>
#include <variant>
#include <vector>

#include "coordinator/journal/journal.h"
#include "coordinator/service/request_desk.h"

namespace accord {

class JournalThread {
 public:
  // The journal must outlive this. `wake` rouses the loop: take() has something.
  JournalThread(Journal& journal, std::function<void()> wake);
  // Everything that was asked for is done first.
  ~JournalThread();
  JournalThread(const JournalThread&) = delete;
  JournalThread& operator=(const JournalThread&) = delete;

  using Work = std::variant<RequestDesk::Accept, RequestDesk::Finish, RequestDesk::Recall,
                            RequestDesk::Forget>;
  // In order, as far as anybody can tell.
  void start(Work work);

  struct Accepted {
    std::vector<std::string> ids;
    std::string fault;  // empty: they are written
  };
  struct Stored {
    std::vector<std::string> ids;
    std::string fault;
  };
  struct Recalled {
    std::string id;
    tl::expected<Plan, std::string> plan;
  };
  struct NotForgotten {};  // Forget failed; where it is done nothing is reported
  using Outcome = std::variant<Accepted, Stored, Recalled, NotForgotten>;
  std::optional<Outcome> take();

 private:
  void serve();
  void carry_out(const RequestDesk::Accept& work);
  void carry_out(const RequestDesk::Finish& work);
  void carry_out(const RequestDesk::Recall& work);
  void carry_out(const RequestDesk::Forget& work);
  void report(Outcome outcome);
  // People, through the log, how a write went.
  void tell(const std::string& fault, const char* what_follows);

  Journal& journal_;
  std::function<void()> wake_;
  std::mutex mutex_;
  std::condition_variable has_work_;
  bool quit_ = false;
  std::deque<Work> work_;
  std::deque<Outcome> outcomes_;
  bool is_failing_ = false;  // the thread's own
  std::thread thread_;       // last
};

}  // namespace accord
