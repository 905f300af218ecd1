#define DSC_EXTERN

#include "instantiations.h"
