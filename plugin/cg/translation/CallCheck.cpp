#include "cg/translation/CallCheck.h"

#include "cg/translation/Prelude.h"

#include <glslang/MachineIndependent/localintermediate.h>

namespace Lixel::Cg {
namespace {

class CallCheck : public glslang::TIntermTraverser {
public:
    explicit CallCheck(Messages& messages) : mMessages(messages) {}

    bool visitAggregate(glslang::TVisit, glslang::TIntermAggregate* node) override {
        if (node->getOp() == glslang::EOpFunctionCall) {
            if (const char* reason = whyRefused(std::string_view(node->getName().c_str()))) {
                const glslang::TSourceLoc place = node->getLoc();
                mMessages.push_back({Message::Kind::Error, place.getFilename(),
                                     static_cast<unsigned>(place.line), reason});
            }
        }
        return true;
    }

private:
    Messages& mMessages;
};

} // namespace

void checkCalls(const glslang::TIntermediate& program, Messages& messages) {
    if (program.getTreeRoot() == nullptr) return;
    CallCheck check(messages);
    program.getTreeRoot()->traverse(&check);
}

} // namespace Lixel::Cg
