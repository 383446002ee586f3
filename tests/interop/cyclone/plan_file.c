#include <stdio.h>

#include "gathered_plan.h"
#include "json.h"

static void print_waypoints(const struct gathered_path* path, FILE* out) {
  const char* between = "";
  for (uint32_t p = 0; p < path->piece_count; ++p) {
    const accord_fleet_RobotPlan* piece = path->pieces[p];
    for (uint32_t w = 0; w < piece->times._length; ++w) {
      fprintf(out, "%s\n      {\"t\": %.17g, \"q\": ", between, piece->times._buffer[w]);
      print_numbers(&piece->configurations._buffer[w * piece->dof], piece->dof, out);
      fputs("}", out);
      between = ",";
    }
  }
}

// Robots by the names of their places, or NULL: by these.
static void print_segments(const struct gathered_path* path, char* const* names, FILE* out) {
  const char* between = "";
  for (uint32_t p = 0; p < path->piece_count; ++p) {
    const accord_fleet_RobotPlan* piece = path->pieces[p];
    for (uint32_t s = 0; s < piece->segments._length; ++s) {
      const accord_fleet_Segment* segment = &piece->segments._buffer[s];
      fprintf(out, "%s\n      {\"from\": %.17g, \"to\": %.17g, \"robots\": [", between,
              segment->from, segment->to);
      for (uint32_t i = 0; i < segment->robots._length; ++i) {
        if (i > 0) fputs(", ", out);
        if (names != NULL) {
          print_text(names[segment->robots._buffer[i]], out);
        } else {
          fprintf(out, "%u", segment->robots._buffer[i]);
        }
      }
      fputs("], \"solver\": ", out);
      print_text(segment->solver, out);
      fputs("}", out);
      between = ",";
    }
  }
}

static void print_head(const accord_fleet_Plan* outcome, FILE* out) {
  static const char* const kStatuses[] = {"solved", "infeasible", "timeout", "cancelled",
                                          "invalid"};
  fputs("{\n  \"accord\": \"plan/1\",\n  \"scene\": ", out);
  print_text(outcome->scene, out);
  fputs(",\n  \"status\": ", out);
  print_text(outcome->status < 5 ? kStatuses[outcome->status] : "unknown", out);
  fputs(",\n  \"message\": ", out);
  print_text(outcome->message, out);
  fputs(",\n  \"method\": ", out);
  print_text(outcome->method, out);
  fprintf(out, ",\n  \"seed\": %llu,\n  \"timestep\": %.17g,\n  \"planning_time\": %.17g",
          (unsigned long long)outcome->seed, outcome->timestep, outcome->planning_time);
  fprintf(out, ",\n  \"makespan\": %.17g,\n  \"sum_of_costs\": %.17g", outcome->makespan,
          outcome->sum_of_costs);
  fprintf(out, ",\n  \"sum_of_costs_timesteps\": %lld", (long long)outcome->sum_of_costs_timesteps);
}

static void print_named(const struct gathered_path* path, const char* robot, char* const* names,
                        FILE* out) {
  fputs("{\"name\": ", out);
  print_text(robot, out);
  fputs(",\n     \"waypoints\": [", out);
  print_waypoints(path, out);
  fputs("],\n     \"segments\": [", out);
  print_segments(path, names, out);
  fputs("]}", out);
}

void print_path(const struct gathered_path* path, FILE* out) {
  print_named(path, path->pieces[0]->robot, NULL, out);
}

void print_plan(const struct gathered_plan* plan, FILE* out) {
  const accord_fleet_Plan* outcome = plan->outcome;
  print_head(outcome, out);
  fputs(",\n  \"robots\": [", out);
  for (uint32_t r = 0; r < outcome->robots._length; ++r) {
    fputs(r == 0 ? "\n    " : ",\n    ", out);
    print_named(&plan->paths[r], outcome->robots._buffer[r], outcome->robots._buffer, out);
  }
  fputs("],\n  \"statistics\": {", out);
  for (uint32_t s = 0; s < outcome->statistics._length; ++s) {
    fputs(s == 0 ? "\n    " : ",\n    ", out);
    print_text(outcome->statistics._buffer[s].name, out);
    fprintf(out, ": %.17g", outcome->statistics._buffer[s].value);
  }
  fputs("}\n}\n", out);
}
