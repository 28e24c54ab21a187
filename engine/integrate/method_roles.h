#pragma once

#include <string>
#include <vector>

#include "engine/integrate/method_info.h"

namespace plumb {

/// Methods that are asked for by what they are for, by those that need one and do not care which.

/// The cheapest step of all, fixed, of order 2.
const MethodInfo& usual_explicit();
/// Of middling order with a fixed step, whose limit of stability everyone knows.
const MethodInfo& classical_explicit();
/// Of high order, with a fixed step or tolerances, and without equations to solve.
const MethodInfo& accurate_explicit();
/// The same for a case: embedded_explicit() where the former does not take it.
const MethodInfo& accurate_explicit(const Case& spec);
/// Embedded pairs, with tolerances and an `order` of 5 or 8 among others. They have nothing in common with
/// `accurate_explicit` but the forces.
const MethodInfo& embedded_explicit();
/// One implicit stage with a fixed step of any length, damped (MethodInfo::damps_with).
const MethodInfo& usual_implicit();
/// The same of order 1, which damps all that moves.
const MethodInfo& first_order_implicit();
/// Of high order with a fixed step of any length, unlike any explicit method.
const MethodInfo& accurate_implicit();
/// Of keeps_energy.
const MethodInfo& energy_keeping();
/// The one that a rigid rod is integrated by.
const MethodInfo& rigid_rod_method();

/// Takes the names of methods out of a list that do not take a case.
void leave_out_others(const Case& spec, std::vector<std::string>& names);

/// Names of a few as unlike as can be, for a comparison of seconds.
std::vector<std::string> few_unlike_methods();

}  // namespace plumb
