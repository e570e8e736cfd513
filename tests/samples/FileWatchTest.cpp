#include "common/FileWatch.h"

#include "EditedFolder.h"
#include "TestStage.h"

namespace Lixel::Tests {
namespace {

TEST(FileWatch, WaitsUntilAFileIsWritten) {
    const BoxOnGround scene; // for OGRE's resource groups
    const EditedFolder folder;
    folder.write("one.txt", "1");
    folder.parse();
    Samples::FileWatch watch(EditedFolder::Group);
    EXPECT_FALSE(watch.changed());
    EXPECT_FALSE(watch.changed());
    folder.write("one.txt", "2");
    EXPECT_FALSE(watch.changed()) << "it may still be written to";
    EXPECT_TRUE(watch.changed());
    EXPECT_FALSE(watch.changed());
    folder.write("one.txt", "3");
    EXPECT_FALSE(watch.changed());
    folder.write("one.txt", "4");
    EXPECT_FALSE(watch.changed());
    EXPECT_TRUE(watch.changed());
}

} // namespace
} // namespace Lixel::Tests
