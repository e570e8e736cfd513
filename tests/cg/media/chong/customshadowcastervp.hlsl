#include "customshadowcastervp.cg"
