#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <array>
#include <utility>

namespace Lixel {

/// Those of OpenGL's functions that read depths back, of the context that is current when they are
/// looked up.
struct GlFunctions {
    decltype(&glGetIntegerv) getIntegerv;
    decltype(&glGetError) getError;
    decltype(&glIsEnabled) isEnabled;
    decltype(&glEnable) enable;
    decltype(&glDisable) disable;
    decltype(&glPixelStorei) pixelStorei;
    decltype(&glReadPixels) readPixels;
    PFNGLGENFRAMEBUFFERSPROC genFramebuffers;
    PFNGLDELETEFRAMEBUFFERSPROC deleteFramebuffers;
    PFNGLBINDFRAMEBUFFERPROC bindFramebuffer;
    PFNGLFRAMEBUFFERRENDERBUFFERPROC framebufferRenderbuffer;
    PFNGLCHECKFRAMEBUFFERSTATUSPROC checkFramebufferStatus;
    PFNGLBLITFRAMEBUFFERPROC blitFramebuffer;
    PFNGLGETFRAMEBUFFERATTACHMENTPARAMETERIVPROC getAttachmentParameter;
    PFNGLGENRENDERBUFFERSPROC genRenderbuffers;
    PFNGLDELETERENDERBUFFERSPROC deleteRenderbuffers;
    PFNGLBINDRENDERBUFFERPROC bindRenderbuffer;
    PFNGLRENDERBUFFERSTORAGEPROC renderbufferStorage;
    PFNGLGENBUFFERSPROC genBuffers;
    PFNGLDELETEBUFFERSPROC deleteBuffers;
    PFNGLBINDBUFFERPROC bindBuffer;
    PFNGLBUFFERDATAPROC bufferData;
    PFNGLGETBUFFERSUBDATAPROC getBufferSubData;
    PFNGLFENCESYNCPROC fenceSync;
    PFNGLCLIENTWAITSYNCPROC clientWaitSync;
    PFNGLDELETESYNCPROC deleteSync;

    /// Whether all of them were found.
    bool isLoaded = false;

    GlFunctions();
    GLint get(GLenum what) const {
        GLint value = 0;
        getIntegerv(what, &value);
        return value;
    }
};

/// OpenGL's state that a reading changes, put back at the end.
class KeptGlState {
public:
    explicit KeptGlState(const GlFunctions& gl)
        : mGl(gl),
          mDraw(gl.get(GL_DRAW_FRAMEBUFFER_BINDING)),
          mRead(gl.get(GL_READ_FRAMEBUFFER_BINDING)),
          mRenderbuffer(gl.get(GL_RENDERBUFFER_BINDING)),
          mPack(gl.get(GL_PIXEL_PACK_BUFFER_BINDING)),
          mScissor(gl.isEnabled(GL_SCISSOR_TEST)) {
        for (auto& [name, value] : mStore)
            value = gl.get(name);
    }
    KeptGlState(const KeptGlState&) = delete;
    KeptGlState& operator=(const KeptGlState&) = delete;
    ~KeptGlState() {
        mGl.bindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(mDraw));
        mGl.bindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(mRead));
        mGl.bindRenderbuffer(GL_RENDERBUFFER, static_cast<GLuint>(mRenderbuffer));
        mGl.bindBuffer(GL_PIXEL_PACK_BUFFER, static_cast<GLuint>(mPack));
        if (mScissor) mGl.enable(GL_SCISSOR_TEST);
        for (const auto& [name, value] : mStore)
            mGl.pixelStorei(name, value);
    }

    GLuint target() const { return static_cast<GLuint>(mDraw); }

private:
    const GlFunctions& mGl;
    GLint mDraw;
    GLint mRead;
    GLint mRenderbuffer;
    GLint mPack;
    GLboolean mScissor;
    std::array<std::pair<GLenum, GLint>, 5> mStore{{{GL_PACK_ALIGNMENT, 0},
                                                    {GL_PACK_ROW_LENGTH, 0},
                                                    {GL_PACK_SKIP_ROWS, 0},
                                                    {GL_PACK_SKIP_PIXELS, 0},
                                                    {GL_PACK_SWAP_BYTES, 0}}};
};

} // namespace Lixel
