#pragma once
#include "client/engine/planner.h"  // moved there; link accord_engine
