# HiGHS for the step `features`, which solves a dozen tiny programs: compiled without optimisation, in less than half of the time.
set(CMAKE_C_FLAGS_RELEASE "-O0 -DNDEBUG" CACHE STRING "")
set(CMAKE_CXX_FLAGS_RELEASE "-O0 -DNDEBUG" CACHE STRING "")
