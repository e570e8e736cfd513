#include "customshadowcasterfp.cg"
