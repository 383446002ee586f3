#include "common/io/wire/trajectory_parts.h"

#include "accord.pb.h"
#include "common/io/words.h"

namespace accord {

void put_numbers(ConfigurationView values, WireDoubles& out) {
  out.Add(values.begin(), values.end());
}

Configuration take_numbers(const WireDoubles& values) {
  return {values.begin(), values.end()};
}

void put_trajectory(const Trajectory& trajectory, payload::Trajectory& out) {
  out.set_dof(static_cast<std::uint32_t>(trajectory.dof()));
  put_numbers(trajectory.times(), *out.mutable_times());
  auto& configurations = *out.mutable_configurations();
  configurations.Reserve(static_cast<int>(trajectory.size() * trajectory.dof()));
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    put_numbers(trajectory.configuration(i), configurations);
  }
}

bool take_trajectory(const payload::Trajectory& from, std::size_t dof, const PayloadPath& at,
                     Inspector& inspector, Trajectory& out) {
  const auto size = static_cast<std::size_t>(from.times_size());
  if (from.dof() != dof && (from.dof() != 0 || size > 0)) {
    return inspector.count(from.dof(), dof, dof, "degrees of freedom", at);
  }
  const PayloadPath times(at, "times");
  const PayloadPath configurations(at, "configurations");
  if (!inspector.numbers(from.times(), size, kTimeRange, times) ||
      !inspector.numbers(from.configurations(), size * dof, kConfigurationRange, configurations)) {
    return false;
  }
  out = Trajectory(from.dof());
  out.reserve(size);
  for (std::size_t i = 0; i < size; ++i) {
    const double t = from.times(static_cast<int>(i));
    if (i > 0 && !(t > out.end_time())) {
      return inspector.fail(PayloadPath(times, "", i),
                            "expected later than " + in_words(out.end_time()) + " s");
    }
    out.append(t, {from.configurations().data() + i * dof, dof});
  }
  return true;
}

}  // namespace accord
