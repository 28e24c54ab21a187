#include "report/program/verbs.h"

int main(int count, char** arguments) {
  return plumb::program(count, arguments);
}
