// Translations that are kept in memory and on disk.

#include "Translated.h"

#include "cg/translation/Cache.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

namespace Lixel::Tests {
namespace {

using Cg::Request;
using Cg::Translation;
using Cg::TranslationCache;

class Cache : public testing::Test {
protected:
    Cache()
        : mFolder(std::filesystem::temp_directory_path() /
                  ("lixel-cg-cache-" + std::to_string(getpid()))) {
        std::filesystem::remove_all(mFolder);
    }
    ~Cache() override { std::filesystem::remove_all(mFolder); }

    /// A program that has all that a translation can have.
    static Request
    request(const std::string& included = "float4 scale(float4 x) { return x * 2; }") {
        return requestOf({Cg::Stage::Fragment,
                          "#include \"scale.cgh\"\n"
                          "float4 main(float4 v : VPOS, uniform sampler2D s : TEXUNIT2,\n"
                          "            uniform float2 tint = float2(0.5, 1), uniform float u[3])\n"
                          "    : COLOR { return scale(tex2D(s, v.xy) * tint.xyxy); }",
                          Cg::Language::Cg,
                          330,
                          {{"scale.cgh", included}}});
    }

    std::filesystem::path onlyFile() const {
        std::filesystem::path file;
        unsigned count = 0;
        for (const auto& entry : std::filesystem::directory_iterator(mFolder)) {
            file = entry.path();
            ++count;
        }
        EXPECT_EQ(count, 1u);
        return file;
    }

    static std::string bytesOf(const std::filesystem::path& path) {
        std::ifstream file(path, std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(file), {});
    }

    const std::filesystem::path mFolder;
};

void expectEqual(const Translation& a, const Translation& b) {
    EXPECT_EQ(a.glsl, b.glsl);
    EXPECT_EQ(a.attributes, b.attributes);
    ASSERT_EQ(a.parameters.size(), b.parameters.size());
    for (std::size_t i = 0; i < a.parameters.size(); ++i) {
        EXPECT_EQ(a.parameters[i].name, b.parameters[i].name);
        EXPECT_EQ(a.parameters[i].glslName, b.parameters[i].glslName);
        EXPECT_EQ(a.parameters[i].columns, b.parameters[i].columns);
        EXPECT_EQ(a.parameters[i].elements, b.parameters[i].elements);
        EXPECT_EQ(a.parameters[i].used, b.parameters[i].used);
        EXPECT_EQ(a.parameters[i].defaults, b.parameters[i].defaults);
    }
    ASSERT_EQ(a.samplers.size(), b.samplers.size());
    for (std::size_t i = 0; i < a.samplers.size(); ++i)
        EXPECT_EQ(a.samplers[i].unit, b.samplers[i].unit);
    ASSERT_EQ(a.messages.size(), b.messages.size());
    for (std::size_t i = 0; i < a.messages.size(); ++i)
        EXPECT_EQ(toString(a.messages[i]), toString(b.messages[i]));
}

TEST_F(Cache, FindsInMemory) {
    TranslationCache cache;
    const Translation first = cache.translate(request());
    ASSERT_TRUE(first.succeeded());
    expectEqual(cache.translate(request()), first);
    EXPECT_EQ(cache.counts().made, 1u);
    EXPECT_EQ(cache.counts().inMemory, 1u);
}

TEST_F(Cache, FindsOnDisk) {
    TranslationCache writer;
    writer.setFolder(mFolder);
    const Translation first = writer.translate(request());
    TranslationCache reader;
    reader.setFolder(mFolder);
    expectEqual(reader.translate(request()), first);
    EXPECT_EQ(reader.counts().onDisk, 1u);
    EXPECT_EQ(reader.counts().made, 0u);
}

TEST_F(Cache, SeesEachChange) {
    TranslationCache cache;
    cache.setFolder(mFolder);
    cache.translate(request());
    const auto isMade = [&](const Request& changed) {
        const unsigned before = cache.counts().made;
        EXPECT_TRUE(cache.translate(changed).succeeded());
        return cache.counts().made == before + 1;
    };
    EXPECT_TRUE(isMade(request("float4 scale(float4 x) { return x * 3; }")));
    EXPECT_TRUE(isMade(request()));
    Request changed = request();
    changed.defines.push_back({"A", "1"});
    EXPECT_TRUE(isMade(changed));
    changed.glslVersion = 120;
    EXPECT_TRUE(isMade(changed));
    changed.file = "other.cg";
    EXPECT_TRUE(isMade(changed));
    changed.source += ' ';
    EXPECT_TRUE(isMade(changed));
    EXPECT_FALSE(isMade(changed));
}

TEST_F(Cache, DoesNotKeepErrors) {
    TranslationCache cache;
    cache.setFolder(mFolder);
    Request broken = request("float4 scale(float4 x) { return y; }");
    EXPECT_FALSE(cache.translate(broken).succeeded());
    EXPECT_FALSE(std::filesystem::exists(mFolder));
    EXPECT_TRUE(cache.translate(request()).succeeded());
}

/// A truncated or corrupted file is ignored and replaced.
TEST_F(Cache, BrokenAndForeignFiles) {
    TranslationCache writer;
    writer.setFolder(mFolder);
    const Translation first = writer.translate(request());
    const auto path = onlyFile();
    const std::string good = bytesOf(path);
    const auto check = [&](const std::string& bad) { EXPECT_FALSE(Cg::fromFile(bad).has_value()); };
    for (std::size_t size = 0; size < good.size(); size += 7)
        check(good.substr(0, size));
    for (std::size_t at = 0; at < good.size(); at += 5) {
        std::string bad = good;
        bad[at] = static_cast<char>(bad[at] ^ 0x41);
        check(bad);
    }
    check(good + 'x');
    for (const std::string& bad : {std::string(), std::string("PNG"), good.substr(0, 60)}) {
        std::ofstream(path, std::ios::binary) << bad;
        TranslationCache reader;
        reader.setFolder(mFolder);
        expectEqual(reader.translate(request()), first);
        EXPECT_EQ(reader.counts().made, 1u);
        EXPECT_EQ(bytesOf(path), good);
    }
}

/// A file whose checksum is right, because it was made so, and whose numbers are not.
TEST_F(Cache, FilesThatLie) {
    TranslationCache writer;
    writer.setFolder(mFolder);
    writer.translate(request());
    const std::string good = bytesOf(onlyFile());
    const std::size_t head = good.find('\n') + 1;
    const std::size_t body = head + 24;
    for (std::size_t at = body; at < good.size(); at += 3) {
        std::string bad = good;
        for (std::size_t i = at; i < std::min(at + 8, bad.size()); ++i)
            bad[i] = '\xFF';
        const std::uint64_t hash = Cg::hashOf(std::string_view(bad).substr(body));
        bad.replace(head + 16, 8, reinterpret_cast<const char*>(&hash), 8);
        const auto entry = Cg::fromFile(bad);
        EXPECT_TRUE(!entry || entry->translation.succeeded());
    }
}

TEST_F(Cache, FolderThatCannotBeWritten) {
    std::ofstream(mFolder) << "a file";
    TranslationCache cache;
    cache.setFolder(mFolder);
    EXPECT_TRUE(cache.translate(request()).succeeded());
    EXPECT_TRUE(cache.takeFailedFolder());
    EXPECT_FALSE(cache.takeFailedFolder());
    cache.translate(request());
    EXPECT_EQ(cache.counts().inMemory, 1u);
}

TEST_F(Cache, SeveralThreads) {
    TranslationCache cache;
    cache.setFolder(mFolder);
    const std::string expected = translate(request()).glsl;
    std::vector<std::thread> threads;
    std::array<bool, 4> right = {};
    for (bool& all : right)
        threads.emplace_back([&cache, &expected, &all] {
            all = true;
            for (int i = 0; i < 20; ++i)
                all = all && cache.translate(request()).glsl == expected;
        });
    for (std::thread& thread : threads)
        thread.join();
    for (const bool all : right)
        EXPECT_TRUE(all);
    onlyFile();
}

} // namespace
} // namespace Lixel::Tests
