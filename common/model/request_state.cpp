#include "common/model/request_state.h"

namespace accord {

std::string_view to_string(Rejection reason) {
  switch (reason) {
    case Rejection::kNone:
      return "none";
    case Rejection::kBadId:
      return "bad_id";
    case Rejection::kIdInUse:
      return "id_in_use";
    case Rejection::kBadScene:
      return "bad_scene";
    case Rejection::kUnknownScene:
      return "unknown_scene";
    case Rejection::kBadQuery:
      return "bad_query";
    case Rejection::kBadOption:
      return "bad_option";
    case Rejection::kTooLarge:
      return "too_large";
    case Rejection::kQueueFull:
      return "queue_full";
    case Rejection::kNoJournal:
      return "no_journal";
    case Rejection::kShuttingDown:
      return "shutting_down";
    case Rejection::kUnknownRequest:
      return "unknown_request";
  }
  return "unknown";
}

std::string_view to_string(RequestPhase phase) {
  switch (phase) {
    case RequestPhase::kQueued:
      return "queued";
    case RequestPhase::kInitialPaths:
      return "initial_paths";
    case RequestPhase::kConflicts:
      return "conflicts";
    case RequestPhase::kProof:
      return "proof";
    case RequestPhase::kFinished:
      return "finished";
  }
  return "unknown";
}

}  // namespace accord
