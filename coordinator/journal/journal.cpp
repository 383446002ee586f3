#include "coordinator/journal/journal.h"

#include <cmath>
#include <unordered_set>

#include "common/io/words.h"

namespace accord {
namespace {

tl::unexpected<std::string> refuse(std::string_view id, std::string_view why) {
  return tl::unexpected("request " + in_quotes(id) + " " + std::string(why));
}

}  // namespace

Journal::Result<std::uint64_t> Journal::accept(const std::vector<AcceptedRequest>& requests) {
  if (requests.empty()) return tl::unexpected(std::string("there is no request to accept"));
  std::unordered_set<std::string_view> ids;
  for (const AcceptedRequest& request : requests) {
    if (request.id.empty()) return refuse(request.id, "has no id");
    if (!std::isfinite(request.accepted_at)) return refuse(request.id, "was accepted at no time");
    if (!ids.insert(request.id).second) return refuse(request.id, "is there twice");
    const auto found = do_find(request.id);
    if (!found) return tl::unexpected(found.error());
    if (*found) return refuse(request.id, "is in the journal already");
  }
  return do_accept(requests);
}

Journal::Result<void> Journal::finish(const std::vector<FinishedRequest>& requests) {
  if (requests.empty()) return {};
  std::unordered_set<std::string_view> ids;
  for (const FinishedRequest& request : requests) {
    if (!std::isfinite(request.finished_at)) return refuse(request.id, "finished at no time");
    if (!ids.insert(request.id).second) return refuse(request.id, "is there twice");
    const auto found = do_find(request.id);
    if (!found) return tl::unexpected(found.error());
    if (!*found) return refuse(request.id, "is not in the journal");
    if ((*found)->outcome) return refuse(request.id, "is finished already");
  }
  return do_finish(requests);
}

Journal::Result<std::optional<JournalEntry>> Journal::find(std::string_view id) const {
  return do_find(id);
}

Journal::Result<std::vector<JournalEntry>> Journal::unfinished() const {
  return do_entries(true);
}

Journal::Result<std::vector<JournalEntry>> Journal::entries() const {
  return do_entries(false);
}

Journal::Result<Bytes> Journal::record(std::string_view id) const {
  const auto found = do_find(id);
  if (!found) return tl::unexpected(found.error());
  if (!*found) return refuse(id, "is not in the journal");
  if ((*found)->outcome) return refuse(id, "is finished: its record is no longer kept");
  return do_record(**found);
}

Journal::Result<std::string> Journal::plan(std::string_view id) const {
  const auto found = do_find(id);
  if (!found) return tl::unexpected(found.error());
  if (!*found) return refuse(id, "is not in the journal");
  if (!(*found)->outcome) return refuse(id, "is not finished");
  return do_plan(**found);
}

Journal::Result<std::size_t> Journal::forget_finished_before(double time, std::size_t most) {
  if (most == 0 || std::isnan(time)) return 0;
  return do_forget(time, most);
}

Journal::Result<JournalCounts> Journal::counts() const {
  return do_counts();
}

}  // namespace accord
