#ifndef OSGWATERREFLECT_TESTS_SUPPORT_CATCH_H
#define OSGWATERREFLECT_TESTS_SUPPORT_CATCH_H

/// Catch2, version 2 or 3: the one place that knows which.
#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
#else
#include <catch2/catch.hpp>
#endif

#endif
