// Every function that a row of the table calls, for four floats at a time: the rows find them by
// argument-dependent lookup. Each agrees with the double value of ops/scalar.hpp to within a few
// units in the last place of a float; tests/cpp/lanes_test.cpp states the bounds.
#pragma once

#include "eval/lanes_exponentials.hpp"
#include "eval/lanes_hyperbolic.hpp"
#include "eval/lanes_inverse_trigonometry.hpp"
#include "eval/lanes_rounding.hpp"
#include "eval/lanes_trigonometry.hpp"
