// A crew whose attempts end as a test says, in the order that it says.
#pragma once

#include <algorithm>
#include <deque>
#include <functional>
#include <utility>
#include <vector>

#include "coordinator/crew.h"

namespace accord::testing {

class ScriptedCrew final : public Crew {
 public:
  explicit ScriptedCrew(std::size_t hands) : hands_(hands) {}

  // How an attempt ends.
  std::function<Attempted(const Attempt&)> outcome;
  // Which of those under way ends next; only the first `hands` are worked on.
  std::function<std::size_t(std::size_t under_way)> next = [](std::size_t) { return 0U; };

  void begin(std::vector<Attempt> attempts) override {
    for (Attempt& attempt : attempts) {
      const auto place = std::ranges::find_if(
          under_way, [&](const Attempt& one) { return one.is_ahead && !attempt.is_ahead; });
      begun.push_back(attempt);
      under_way.insert(place, std::move(attempt));
    }
    most_under_way = std::max(most_under_way, under_way.size());
  }
  void hurry(const std::vector<Ticket>& tickets) override {
    for (Attempt& one : under_way) {
      if (std::ranges::find(tickets, one.ticket) != tickets.end()) one.is_ahead = false;
    }
    std::ranges::stable_partition(under_way, [](const Attempt& one) { return !one.is_ahead; });
  }
  void drop(const std::vector<Ticket>& tickets) override {
    const auto is_dropped = [&](const Attempt& one) {
      return std::ranges::find(tickets, one.ticket) != tickets.end();
    };
    for (const Attempt& one : under_way) {
      if (is_dropped(one)) dropped.push_back(one);
    }
    std::erase_if(under_way, is_dropped);
  }
  std::vector<Attempted> wait(const std::atomic<bool>&) override {
    const auto place =
        under_way.begin() + static_cast<std::ptrdiff_t>(next(std::min(hands_, under_way.size())));
    const Attempt ended = *place;
    under_way.erase(place);
    Attempted out = outcome(ended);
    out.ticket = ended.ticket;
    return {out};
  }
  std::size_t hands() const override { return hands_; }

  std::deque<Attempt> under_way;  // needed ones first
  std::vector<Attempt> begun, dropped;
  std::size_t most_under_way = 0;

 private:
  std::size_t hands_;
};

}  // namespace accord::testing
