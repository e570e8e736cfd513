#include "cg/translation/CacheEntry.h"

#include <glslang/build_info.h>
#include <spirv_cross/spirv_cross_c.h>

#include <cstring>

namespace Lixel::Cg {
namespace {

/// To be raised with each change of what a source is translated to, or of the file's form.
constexpr std::uint32_t TranslatorVersion = 1;

constexpr std::string_view Magic = "Lixel translation of Cg\n";

/// Numbers and texts, one after another. Files are read on the machine that wrote them.
class EntryWriter {
public:
    void number(std::uint64_t value) {
        char bytes[sizeof value];
        std::memcpy(bytes, &value, sizeof value);
        mBytes.append(bytes, sizeof value);
    }
    void real(float value) {
        std::uint32_t bits = 0;
        std::memcpy(&bits, &value, sizeof bits);
        number(bits);
    }
    void text(std::string_view value) {
        number(value.size());
        mBytes += value;
    }
    std::string take() { return std::move(mBytes); }

private:
    std::string mBytes;
};

/// Reads what EntryWriter has written. Beyond the end all is 0 and empty, and isGood is false.
class EntryReader {
public:
    explicit EntryReader(std::string_view bytes) : mBytes(bytes) {}

    std::uint64_t number() {
        std::uint64_t value = 0;
        if (mBytes.size() < sizeof value) return fail();
        std::memcpy(&value, mBytes.data(), sizeof value);
        mBytes.remove_prefix(sizeof value);
        return value;
    }
    float real() {
        const auto bits = static_cast<std::uint32_t>(number());
        float value = 0;
        std::memcpy(&value, &bits, sizeof value);
        return value;
    }
    std::string text() {
        const std::uint64_t size = number();
        if (size > mBytes.size()) {
            fail();
            return {};
        }
        std::string value(mBytes.substr(0, size));
        mBytes.remove_prefix(size);
        return value;
    }
    /// A count of elements that follow; each takes the size of a number or more.
    std::uint64_t count() {
        const std::uint64_t value = number();
        return value > mBytes.size() / sizeof value ? fail() : value;
    }
    bool isGood() const { return mGood; }
    bool isAtEnd() const { return mBytes.empty(); }

private:
    std::uint64_t fail() {
        mGood = false;
        mBytes = {};
        return 0;
    }

    std::string_view mBytes;
    bool mGood = true;
};

void writeParameter(EntryWriter& to, const Parameter& parameter) {
    to.text(parameter.name);
    to.text(parameter.glslName);
    to.number(parameter.base == Parameter::Base::Int ? 1 : 0);
    to.number(parameter.rows);
    to.number(parameter.columns);
    to.number(parameter.elements);
    to.number(parameter.used ? 1 : 0);
    to.number(parameter.defaults.size());
    for (const float value : parameter.defaults)
        to.real(value);
}

Parameter readParameter(EntryReader& from) {
    Parameter parameter;
    parameter.name = from.text();
    parameter.glslName = from.text();
    parameter.base = from.number() == 1 ? Parameter::Base::Int : Parameter::Base::Float;
    parameter.rows = static_cast<unsigned>(from.number());
    parameter.columns = static_cast<unsigned>(from.number());
    parameter.elements = static_cast<unsigned>(from.number());
    parameter.used = from.number() == 1;
    for (std::uint64_t i = from.count(); i > 0; --i)
        parameter.defaults.push_back(from.real());
    return parameter;
}

void writeTranslation(EntryWriter& to, const Translation& translation) {
    to.text(translation.glsl);
    to.number(translation.parameters.size());
    for (const Parameter& parameter : translation.parameters)
        writeParameter(to, parameter);
    to.number(translation.samplers.size());
    for (const Sampler& sampler : translation.samplers) {
        to.text(sampler.name);
        to.text(sampler.glslName);
        to.text(sampler.glslType);
        to.number(sampler.unit);
    }
    to.number(translation.attributes.size());
    for (const std::string& attribute : translation.attributes)
        to.text(attribute);
    to.number(translation.messages.size());
    for (const Message& message : translation.messages) {
        to.text(message.file);
        to.number(message.line);
        to.text(message.text);
    }
}

Translation readTranslation(EntryReader& from) {
    Translation translation;
    translation.glsl = from.text();
    for (std::uint64_t i = from.count(); i > 0; --i)
        translation.parameters.push_back(readParameter(from));
    for (std::uint64_t i = from.count(); i > 0; --i) {
        Sampler sampler;
        sampler.name = from.text();
        sampler.glslName = from.text();
        sampler.glslType = from.text();
        sampler.unit = static_cast<unsigned>(from.number());
        translation.samplers.push_back(std::move(sampler));
    }
    for (std::uint64_t i = from.count(); i > 0; --i)
        translation.attributes.push_back(from.text());
    for (std::uint64_t i = from.count(); i > 0; --i) {
        // Those with errors are not kept.
        Message message;
        message.kind = Message::Kind::Warning;
        message.file = from.text();
        message.line = static_cast<unsigned>(from.number());
        message.text = from.text();
        translation.messages.push_back(std::move(message));
    }
    return translation;
}

} // namespace

std::size_t CacheEntry::size() const {
    std::size_t bytes = key.size() + translation.glsl.size();
    for (const IncludedFile& file : includes)
        bytes += file.name.size() + file.text.size();
    return bytes;
}

std::string keyOf(const Request& request) {
    EntryWriter key;
    key.number(TranslatorVersion);
    for (const int part : {GLSLANG_VERSION_MAJOR, GLSLANG_VERSION_MINOR, GLSLANG_VERSION_PATCH})
        key.number(static_cast<std::uint64_t>(part));
    key.text(spvc_get_commit_revision_and_timestamp());
    key.number(request.language == Language::Cg ? 0 : 1);
    key.number(request.stage == Stage::Vertex ? 0 : 1);
    key.text(request.source);
    key.text(request.file);
    key.text(request.profile);
    key.text(request.entry);
    key.number(request.glslVersion);
    key.number(request.columnMajor ? 1 : 0);
    key.number(request.clampColours ? 1 : 0);
    for (const Define& define : request.defines) {
        key.text(define.name);
        key.text(define.value);
    }
    return key.take();
}

bool hasSameIncludes(const CacheEntry& entry, const Request& request) {
    for (const IncludedFile& file : entry.includes) {
        if (!request.readInclude) return false;
        const auto text = request.readInclude(file.name);
        if (!text || *text != file.text) return false;
    }
    return true;
}

std::uint64_t hashOf(std::string_view text) {
    // FNV-1a.
    std::uint64_t hash = 14695981039346656037u;
    for (const char c : text) {
        hash ^= static_cast<unsigned char>(c);
        hash *= 1099511628211u;
    }
    return hash;
}

std::string toFile(const CacheEntry& entry) {
    EntryWriter body;
    body.text(entry.key);
    body.number(entry.includes.size());
    for (const IncludedFile& file : entry.includes) {
        body.text(file.name);
        body.text(file.text);
    }
    writeTranslation(body, entry.translation);
    const std::string bytes = body.take();
    EntryWriter head;
    head.number(TranslatorVersion);
    head.number(bytes.size());
    head.number(hashOf(bytes));
    return std::string(Magic) + head.take() + bytes;
}

std::optional<CacheEntry> fromFile(std::string_view file) {
    if (!file.starts_with(Magic)) return {};
    file.remove_prefix(Magic.size());
    constexpr std::size_t HeadSize = 3 * sizeof(std::uint64_t);
    EntryReader head(file);
    const std::uint64_t version = head.number();
    const std::uint64_t size = head.number();
    const std::uint64_t hash = head.number();
    if (!head.isGood() || version != TranslatorVersion) return {};
    file.remove_prefix(HeadSize);
    if (file.size() != size || hashOf(file) != hash) return {};
    EntryReader body(file);
    CacheEntry entry;
    entry.key = body.text();
    for (std::uint64_t i = body.count(); i > 0; --i) {
        IncludedFile include;
        include.name = body.text();
        include.text = body.text();
        entry.includes.push_back(std::move(include));
    }
    entry.translation = readTranslation(body);
    if (!body.isGood() || !body.isAtEnd() || !entry.translation.succeeded()) return {};
    return entry;
}

} // namespace Lixel::Cg
