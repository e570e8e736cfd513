// Observers that come and go while they are told.

#include "TestStage.h"

#include <functional>
#include <memory>
#include <string>

namespace Lixel::Tests {
namespace {

/// Writes its name down, and then does whatever it was given to do.
class Scribe : public ShadowMapObserver {
public:
    Scribe(std::string& record, char name) : mRecord(record), mName(name) {
        addShadowMapObserver(*this);
    }
    void shadowMapFitted(const ShadowMap&) override {
        mRecord += mName;
        // It may destroy this.
        const std::function<void()> deed = std::exchange(then, nullptr);
        if (deed) deed();
    }
    std::function<void()> then;

private:
    std::string& mRecord;
    char mName;
};

class Observers : public testing::Test {
protected:
    std::string nextFrame() {
        record.clear();
        scene.stage.drawFrame();
        return record;
    }
    BoxOnGround scene;
    std::string record;
};

TEST_F(Observers, AreToldInTheOrderInWhichTheyWereAdded) {
    Scribe a(record, 'a');
    Scribe b(record, 'b');
    Scribe c(record, 'c');
    EXPECT_EQ(nextFrame(), "abc");
}

TEST_F(Observers, AddingOneTwiceHasNoEffect) {
    Scribe a(record, 'a');
    Scribe b(record, 'b');
    addShadowMapObserver(a);
    EXPECT_EQ(nextFrame(), "ab");
}

TEST_F(Observers, MayRemoveThemselvesWhileTheyAreTold) {
    Scribe a(record, 'a');
    Scribe b(record, 'b');
    Scribe c(record, 'c');
    a.then = [&] { removeShadowMapObserver(a); };
    c.then = [&] { removeShadowMapObserver(c); };
    EXPECT_EQ(nextFrame(), "abc");
    EXPECT_EQ(nextFrame(), "b");
}

TEST_F(Observers, MayRemoveOthersWhileTheyAreTold) {
    Scribe a(record, 'a');
    Scribe b(record, 'b');
    Scribe c(record, 'c');
    b.then = [&] {
        removeShadowMapObserver(a);
        removeShadowMapObserver(c);
    };
    EXPECT_EQ(nextFrame(), "ab") << "who was removed is not told any more";
    EXPECT_EQ(nextFrame(), "b");
}

TEST_F(Observers, MayBeDestroyedWhileTheyAreTold) {
    auto a = std::make_unique<Scribe>(record, 'a');
    auto b = std::make_unique<Scribe>(record, 'b');
    Scribe c(record, 'c');
    a->then = [&] {
        b.reset();
        a.reset();
    };
    EXPECT_EQ(nextFrame(), "ac");
    EXPECT_EQ(nextFrame(), "c");
}

TEST_F(Observers, MayAddOthersWhileTheyAreTold) {
    Scribe a(record, 'a');
    std::vector<std::unique_ptr<Scribe>> more;
    a.then = [&] {
        // More than there is room for.
        for (int i = 0; i < 100; ++i)
            more.push_back(std::make_unique<Scribe>(record, 'm'));
    };
    EXPECT_EQ(nextFrame(), "a") << "new ones are told from the next map on";
    EXPECT_EQ(nextFrame(), "a" + std::string(100, 'm'));
}

} // namespace
} // namespace Lixel::Tests
