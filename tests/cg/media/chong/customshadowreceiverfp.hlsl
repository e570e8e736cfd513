#include "customshadowreceiverfp.cg"
