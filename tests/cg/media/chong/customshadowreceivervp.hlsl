#include "customshadowreceivervp.cg"
