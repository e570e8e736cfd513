#include "cg/translation/Message.h"

#include <algorithm>

namespace Lixel::Cg {

const Message* firstError(const Messages& messages) {
    const auto error = std::find_if(messages.begin(), messages.end(), [](const Message& message) {
        return message.kind == Message::Kind::Error;
    });
    return error == messages.end() ? nullptr : &*error;
}

std::string toString(const Message& message) {
    std::string result = message.kind == Message::Kind::Error ? "ERROR: " : "WARNING: ";
    if (!message.file.empty()) {
        result += message.file;
        result += ':';
    }
    if (message.line > 0) {
        result += std::to_string(message.line);
        result += ':';
    }
    if (!message.file.empty() || message.line > 0) result += ' ';
    return result + message.text;
}

} // namespace Lixel::Cg
