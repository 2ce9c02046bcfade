#pragma once

// RapidCheck's GoogleTest glue needs GoogleTest's header first; this keeps formatters from
// reordering the two.
#include <gtest/gtest.h>
// clang-format off
#include <rapidcheck/gtest.h>
// clang-format on
