#pragma once

#include <OgrePrerequisites.h>

#include <string>
#include <vector>

namespace Ogre::RTShader {
class ShaderGenerator;
} // namespace Ogre::RTShader

namespace Lixel {

/** Programs that the shader system has made, and is to make anew when what they include was edited.

    It names a program by its calls and defines, not by the text that it includes, and does not make
    a program again while there is one of that name. So all programs have a number among their
    defines, which is another one after each edit.
*/
class MadePrograms {
public:
    /// What all of them are to be made with; empty before the first edit.
    const std::string& define() const { return mDefine; }

    /** Makes the programs of schemes anew, with what they include as it is now, if all of them
        compile so.
        @return whether they do. Otherwise they stay as they are. */
    bool makeAnew(Ogre::RTShader::ShaderGenerator& generator,
                  const std::vector<Ogre::String>& schemes);

private:
    std::string mDefine;
    int mEdits = 0;
};

} // namespace Lixel
