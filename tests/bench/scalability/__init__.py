"""What tests/bench/scaling does: measures runs on this machine, and reads those simulated."""
