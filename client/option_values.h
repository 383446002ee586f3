// What the values of options mean, where CLI11 would take more than it should or say less than it
// could. Errors are CLI11's, so that all that is wrong with a command line reads alike.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace accord {

// A non-negative integer of decimal digits only, below 2^64. As a transform it drops leading zeros,
// which CLI11 would take for octal.
CLI::Validator plain_integer();

// A finite number from `least` to `most`, both included.
CLI::Validator seconds_within(double least, double most);

// The name of a file, or "-" for standard output; not nothing.
CLI::Validator output_name();

// The names in a list "a,b". Throws CLI::ValidationError: an item is empty, unknown, or there
// twice.
std::vector<std::string> solvers_in(std::string_view list,
                                    const std::vector<std::string>& known_names);

// Throws CLI::ValidationError where the output is one of the inputs, by whatever path: writing it
// would destroy what somebody made by hand.
void refuse_overwriting(const std::string& output, const std::vector<std::string>& inputs);

}  // namespace accord
