#define DSC_TEST_EXTERN

#include "instantiations.h"
