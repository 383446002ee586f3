// The commands that ask a service. They need Fast DDS, which takes longer to load than a small
// scene to be planned, so they are in a program of their own, accord-fleet, which `accord` becomes
// when its command line names one of them.
#pragma once

#include <array>

namespace accord {

struct ServiceCommand {
  const char* name;
  const char* description;
};

inline constexpr ServiceCommand kSubmitCommand{
    "submit", "Have a scene planned by a service, and prove here what it answers"};
inline constexpr ServiceCommand kWatchCommand{
    "watch", "Show a service, its requests and its workers as they go on, until Ctrl-C"};
inline constexpr ServiceCommand kCancelCommand{
    "cancel", "Cancel requests of a service, and wait for what becomes of each"};
inline constexpr ServiceCommand kHealthCommand{
    "health", "Ask a service's process on this machine whether it is well"};
inline constexpr ServiceCommand kWorkersCommand{"workers", "List the workers of a service"};
inline constexpr ServiceCommand kDoctorCommand{
    "doctor", "Find out why processes see each other, or do not, and no data flows"};

}  // namespace accord
