#include "engine/integrate/sundials/arkode_tables.h"

#include <new>
#include <utility>

#include "engine/integrate/linear_stability.h"

namespace plumb {
namespace {

ARKODE_ERKTableID explicit_table_of(int order) {
  switch (order) {
    case 2:
      return ARKODE_HEUN_EULER_2_1_2;
    case 3:
      return ARKODE_BOGACKI_SHAMPINE_4_2_3;
    case 4:
      return ARKODE_ZONNEVELD_5_3_4;
    case 5:
      return ARKODE_DORMAND_PRINCE_7_4_5;
    case 6:
      return ARKODE_VERNER_8_5_6;
    default:
      return ARKODE_FEHLBERG_13_7_8;
  }
}

ArkodeTable owned(ARKodeButcherTable table) {
  if (table == nullptr) throw std::bad_alloc();
  return ArkodeTable(table);
}

}  // namespace

ArkodeTable explicit_table(int order) {
  ArkodeTable table = owned(ARKodeButcherTable_LoadERK(explicit_table_of(order)));
  // Fehlberg's own use of his pair: advance with the formula of order 7, estimate with that of order 8.
  if (order == 7) {
    std::swap(table->b, table->d);
    std::swap(table->q, table->p);
  }
  return table;
}

ARKODE_DIRKTableID implicit_table_of(int order) {
  switch (order) {
    case 2:
      return ARKODE_TRBDF2_3_3_2;
    case 3:
      return ARKODE_ESDIRK325L2SA_5_2_3;
    case 4:
      return ARKODE_ESDIRK437L2SA_7_3_4;
    default:
      return ARKODE_ESDIRK547L2SA2_7_4_5;
  }
}

ArkodeTable implicit_table(int order) {
  return owned(ARKodeButcherTable_LoadDIRK(implicit_table_of(order)));
}

double amplification(const ArkodeTable& table, double z) {
  const int s = table->stages;
  Eigen::MatrixXd A(s, s);
  Eigen::VectorXd b(s);
  for (int i = 0; i < s; ++i) {
    b[i] = table->b[i];
    for (int j = 0; j < s; ++j) A(i, j) = table->A[i][j];
  }
  return runge_kutta_amplification(A, b, z);
}

}  // namespace plumb
