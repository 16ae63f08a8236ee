#pragma once

#include <cstdio>
#include <cstdlib>

/// States what must hold if our own code is right; never reachable from user input.
#define SCANFUSE_ASSERT(condition)                                                         \
  do {                                                                                     \
    if (!(condition)) {                                                                    \
      std::fprintf(stderr, "%s:%d: internal fault: %s\n", __FILE__, __LINE__, #condition); \
      std::abort();                                                                        \
    }                                                                                      \
  } while (false)
