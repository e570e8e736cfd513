#include "setup/DepthReader.h"

#include "scene/OgreVersions.h"
#include "setup/GlFunctions.h"

#include <OgreRenderTarget.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

namespace Lixel {
namespace {

/// From one column or row to the next: odd, so that there is a pixel in the middle.
unsigned stepOf(unsigned pixels, std::size_t count) {
    const double step = static_cast<double>(pixels) / static_cast<double>(std::max(count, 1UL));
    return std::max(DepthReader::LeastStep, 2 * static_cast<unsigned>(step / 2.0) + 1);
}

/// Where a grid's pixels are along one axis of a viewport.
struct Axis {
    unsigned count; ///< of the grid's pixels
    unsigned step;  ///< in pixels
    unsigned first; ///< where the first one's block of pixels begins
    unsigned beside;

    /// @param pixels of the viewport
    Axis(unsigned pixels, std::size_t wanted) : step(stepOf(pixels, wanted)) {
        // Neighbours are near enough to show the same surface, and as far from each other as that
        // allows, for depths' resolution.
        beside = std::max(step / 8, 1U);
        count = pixels > 2 * beside ? (pixels - 2 * beside) / step : 0;
        first = (pixels - count * step) / 2;
    }

    double ndcFirst(unsigned pixels) const {
        return (2.0 * (first + step / 2) + 1.0) / pixels - 1.0;
    }
};

/// How a framebuffer stores depths.
struct DepthFormat {
    GLint bits = 0;
    bool isFloat = false;
    bool hasStencil = false;
    GLint samples = 0;

    bool operator==(const DepthFormat&) const = default;

    /// As a renderbuffer's; 0 for none that OpenGL has.
    GLenum internal() const {
        if (isFloat) return hasStencil ? GL_DEPTH32F_STENCIL8 : GL_DEPTH_COMPONENT32F;
        if (hasStencil) return bits == 24 ? GL_DEPTH24_STENCIL8 : 0;
        switch (bits) {
        case 16:
            return GL_DEPTH_COMPONENT16;
        case 24:
            return GL_DEPTH_COMPONENT24;
        case 32:
            return GL_DEPTH_COMPONENT32;
        default:
            return 0;
        }
    }
};

} // namespace

/// What is made of OpenGL's functions.
struct DepthReader::Gl : GlFunctions {
    DepthFormat format;
    /// Of the viewport that it was prepared for.
    GLsizei width = 0;
    GLsizei height = 0;
    std::size_t columns = 0;
    std::size_t rows = 0;
    Axis across{0, 1};
    Axis up{0, 1};
    /// One depth a pixel, of a multisampled viewport; 0 of others.
    GLuint resolved = 0;

    DepthFormat boundFormat() const;
    bool hasGrid() const { return across.count > 0 && up.count > 0; }
    GLsizei gridSize() const { return static_cast<GLsizei>(across.count * up.count); }
    GLsizei gatheredHeight() const { return static_cast<GLsizei>(DepthGrid::Sides * up.count); }
    GLuint makeDepthBuffer(GLsizei bufferWidth, GLsizei bufferHeight) const;
    class Framebuffer;
    bool gather(GLuint target, GLint left, GLint bottom, GLuint gathered) const;
    void copy(GLuint gathered, GLuint buffer) const;
};

/// One reading.
struct DepthReader::Slot {
    enum class Stage { Free, Gathering, Copying };
    Stage stage = Stage::Free;
    /// The grid's depths and those of its pixels' neighbours, one upon the other.
    GLuint gathered = 0;
    /// Their copy in memory.
    GLuint buffer = 0;
    /// Tells that the stage is over. Null in none.
    GLsync fence = nullptr;
    std::uint64_t number = 0;
    bool isFlipped = false;
    bool isReversed = false;
};

DepthFormat DepthReader::Gl::boundFormat() const {
    const bool isWindow = get(GL_DRAW_FRAMEBUFFER_BINDING) == 0;
    const auto ask = [&](GLenum attachment, GLenum what) {
        GLint value = 0;
        getAttachmentParameter(GL_DRAW_FRAMEBUFFER, attachment, what, &value);
        return value;
    };
    DepthFormat result;
    const GLenum depth = isWindow ? GL_DEPTH : GL_DEPTH_ATTACHMENT;
    if (ask(depth, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) == GL_NONE) return result;
    result.bits = ask(depth, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE);
    result.isFloat = ask(depth, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_FLOAT;
    const GLenum stencil = isWindow ? GL_STENCIL : GL_STENCIL_ATTACHMENT;
    result.hasStencil = ask(stencil, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_NONE &&
                        ask(stencil, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE) > 0;
    result.samples = get(GL_SAMPLE_BUFFERS) > 0 ? get(GL_SAMPLES) : 0;
    return result;
}

GLuint DepthReader::Gl::makeDepthBuffer(GLsizei bufferWidth, GLsizei bufferHeight) const {
    GLuint result = 0;
    genRenderbuffers(1, &result);
    bindRenderbuffer(GL_RENDERBUFFER, result);
    renderbufferStorage(GL_RENDERBUFFER, format.internal(), bufferWidth, bufferHeight);
    return result;
}

/// A framebuffer with depths alone, while it lives. A framebuffer belongs to one context, and
/// windows have contexts of their own: so it is made anew each time, unlike all else.
class DepthReader::Gl::Framebuffer {
public:
    Framebuffer(const Gl& gl, GLuint depths) : mGl(gl) {
        gl.genFramebuffers(1, &mName);
        gl.bindFramebuffer(GL_DRAW_FRAMEBUFFER, mName);
        gl.framebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
                                   depths);
        if (gl.format.hasStencil)
            gl.framebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, GL_STENCIL_ATTACHMENT, GL_RENDERBUFFER,
                                       depths);
    }
    Framebuffer(const Framebuffer&) = delete;
    Framebuffer& operator=(const Framebuffer&) = delete;
    ~Framebuffer() { mGl.deleteFramebuffers(1, &mName); }

    bool isComplete() const {
        return mGl.checkFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    }
    GLuint name() const { return mName; }

private:
    const Gl& mGl;
    GLuint mName = 0;
};

/// Gathers the depths of a viewport whose lower left pixel is given.
/// @return whether OpenGL can
bool DepthReader::Gl::gather(GLuint target, GLint left, GLint bottom, GLuint gathered) const {
    disable(GL_SCISSOR_TEST);
    bindFramebuffer(GL_READ_FRAMEBUFFER, target);
    std::optional<Framebuffer> single;
    if (resolved != 0) {
        single.emplace(*this, resolved);
        if (!single->isComplete()) return false;
        blitFramebuffer(left, bottom, left + width, bottom + height, 0, 0, width, height,
                        GL_DEPTH_BUFFER_BIT, GL_NEAREST);
        bindFramebuffer(GL_READ_FRAMEBUFFER, single->name());
        left = bottom = 0;
    }
    const Framebuffer all(*this, gathered);
    if (!all.isComplete()) return false;
    const auto columnCount = static_cast<GLint>(across.count);
    const auto rowCount = static_cast<GLint>(up.count);
    const auto besideX = static_cast<GLint>(across.beside);
    const auto besideY = static_cast<GLint>(up.beside);
    const std::array<std::pair<GLint, GLint>, DepthGrid::Sides> shifts = {
        {{0, 0}, {-besideX, 0}, {besideX, 0}, {0, -besideY}, {0, besideY}}};
    for (std::size_t side = 0; side < shifts.size(); ++side) {
        const GLint x = left + static_cast<GLint>(across.first) + shifts[side].first;
        const GLint y = bottom + static_cast<GLint>(up.first) + shifts[side].second;
        const GLint row = static_cast<GLint>(side) * rowCount;
        // Of each block of pixels the one in its middle is taken.
        blitFramebuffer(x, y, x + static_cast<GLint>(across.count * across.step),
                        y + static_cast<GLint>(up.count * up.step), 0, row, columnCount,
                        row + rowCount, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    }
    return true;
}

/// Has gathered depths copied into a buffer. Puts no state back.
void DepthReader::Gl::copy(GLuint gathered, GLuint buffer) const {
    const Framebuffer all(*this, gathered);
    bindFramebuffer(GL_READ_FRAMEBUFFER, all.name());
    bindBuffer(GL_PIXEL_PACK_BUFFER, buffer);
    pixelStorei(GL_PACK_ALIGNMENT, 4);
    for (const GLenum name :
         {GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS, GL_PACK_SWAP_BYTES})
        pixelStorei(name, 0);
    readPixels(0, 0, static_cast<GLsizei>(across.count), gatheredHeight(), GL_DEPTH_COMPONENT,
               GL_FLOAT, nullptr);
}

DepthReader::DepthReader() = default;

DepthReader::~DepthReader() {
    release();
}

/// OpenGL's objects that nobody needs any more. They are destroyed where a reading begins: elsewhere
/// another context may be current, or none.
struct DepthReader::Discarded {
    std::vector<GLuint> buffers;
    std::vector<GLuint> renderbuffers;
    std::vector<GLsync> fences;

    static Discarded& all() {
        static Discarded& discarded = *new Discarded; // as long as any reader
        return discarded;
    }
    void destroy(const Gl& gl) {
        for (const GLsync fence : fences)
            gl.deleteSync(fence);
        if (!buffers.empty())
            gl.deleteBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());
        if (!renderbuffers.empty())
            gl.deleteRenderbuffers(static_cast<GLsizei>(renderbuffers.size()),
                                   renderbuffers.data());
        *this = {};
    }
};

void DepthReader::forgetDiscarded() {
    Discarded::all() = {};
}

void DepthReader::release() {
    Discarded& discarded = Discarded::all();
    for (std::unique_ptr<Slot>& slot : mSlots) {
        if (slot) {
            if (slot->fence != nullptr) discarded.fences.push_back(slot->fence);
            discarded.buffers.push_back(slot->buffer);
            discarded.renderbuffers.push_back(slot->gathered);
        }
        slot.reset();
    }
    if (mGl && mGl->resolved != 0)
        discarded.renderbuffers.push_back(std::exchange(mGl->resolved, 0));
}

bool DepthReader::isSupported() {
    const Ogre::RenderSystem* const system = Ogre::Root::getSingleton().getRenderSystem();
    if (system == nullptr) return false;
    const std::string_view name(system->getName());
    return name.starts_with("OpenGL ") && !name.starts_with("OpenGL ES");
}

/// Makes what a viewport's reading needs, where that is not there yet.
/// @param[out] isNew whether it was not
/// @return false where it cannot be read
bool DepthReader::prepare(const Ogre::Viewport& viewport, std::size_t columns, std::size_t rows,
                          bool& isNew) {
    Gl& gl = *mGl;
    const auto width = static_cast<GLsizei>(viewport.getActualWidth());
    const auto height = static_cast<GLsizei>(viewport.getActualHeight());
    const DepthFormat format = gl.boundFormat();
    isNew = !(width == gl.width && height == gl.height && columns == gl.columns &&
              rows == gl.rows && format == gl.format);
    if (!isNew) return isReading();
    release();
    gl.width = width;
    gl.height = height;
    gl.columns = columns;
    gl.rows = rows;
    gl.format = format;
    gl.across = Axis(static_cast<unsigned>(std::max(width, 0)), columns);
    gl.up = Axis(static_cast<unsigned>(std::max(height, 0)), rows);
    if (format.internal() == 0 || !gl.hasGrid()) return false;
    if (format.samples > 0) gl.resolved = gl.makeDepthBuffer(width, height);
    for (std::unique_ptr<Slot>& slot : mSlots) {
        slot = std::make_unique<Slot>();
        slot->gathered =
            gl.makeDepthBuffer(static_cast<GLsizei>(gl.across.count), gl.gatheredHeight());
        gl.genBuffers(1, &slot->buffer);
        gl.bindBuffer(GL_PIXEL_PACK_BUFFER, slot->buffer);
        const auto bytes = static_cast<GLsizeiptr>(sizeof(GLfloat) * DepthGrid::Sides) *
                           static_cast<GLsizeiptr>(gl.gridSize());
        gl.bufferData(GL_PIXEL_PACK_BUFFER, bytes, nullptr, GL_STREAM_READ);
    }
    return true;
}

bool DepthReader::begin(const Ogre::Viewport& viewport, std::size_t columns, std::size_t rows,
                        std::uint64_t number) {
    mIsBroken = true;
    if (!mGl) mGl = std::make_unique<Gl>();
    if (!mGl->isLoaded) return false;
    const Gl& gl = *mGl;
    const KeptGlState kept(gl);
    Discarded::all().destroy(gl);
    bool isNew = false;
    if (!prepare(viewport, columns, rows, isNew)) return false;
    mIsBroken = false;
    const auto free = std::ranges::find_if(
        mSlots, [](const std::unique_ptr<Slot>& slot) { return slot->stage == Slot::Stage::Free; });
    if (free == mSlots.end()) return false;
    Slot& slot = **free;

    const Ogre::RenderTarget& target = *viewport.getTarget();
    const auto top = static_cast<GLint>(viewport.getActualTop());
    slot.isFlipped = target.requiresTextureFlipping();
    const GLint bottom = slot.isFlipped ? top
                                        : static_cast<GLint>(target.getHeight()) - top -
                                              static_cast<GLint>(gl.height);
    // Errors are asked for once alone: that may wait for the driver.
    // A context that is lost has no end of them.
    constexpr int MostErrors = 16;
    for (int i = 0; isNew && i < MostErrors && gl.getError() != GL_NO_ERROR; ++i) {
    }
    bool works = gl.gather(kept.target(), static_cast<GLint>(viewport.getActualLeft()), bottom,
                           slot.gathered);
    slot.fence = gl.fenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    works = works && slot.fence != nullptr;
    if (!works || (isNew && gl.getError() != GL_NO_ERROR)) {
        mIsBroken = true;
        release(); // there is no other attempt for such a viewport: what it is like is remembered
        return false;
    }
    slot.stage = Slot::Stage::Gathering;
    slot.number = number;
    slot.isReversed = Ogre::Root::getSingleton().getRenderSystem()->isReverseDepthBufferEnabled();
    return true;
}

/// Whether a reading's stage is over; asks without waiting.
bool DepthReader::isOver(const Slot& slot) const {
    const GLenum state = mGl->clientWaitSync(slot.fence, GL_SYNC_FLUSH_COMMANDS_BIT, 0);
    return state == GL_ALREADY_SIGNALED || state == GL_CONDITION_SATISFIED;
}

/*  1. Have what was gathered copied. A renderer that is none but software copies at once, and would
       wait for the picture if it had to copy before.
    2. Take the latest copy that is there. */
bool DepthReader::fetch(DepthReading& reading) {
    if (!isReading()) return false;
    const Gl& gl = *mGl;
    std::optional<KeptGlState> kept;
    const auto enter = [&](Slot& slot, Slot::Stage stage) {
        gl.deleteSync(slot.fence);
        slot.fence = nullptr;
        slot.stage = stage;
        if (stage == Slot::Stage::Copying)
            slot.fence = gl.fenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    };
    Slot* latest = nullptr;
    for (const std::unique_ptr<Slot>& slot : mSlots) {
        if (slot->stage == Slot::Stage::Gathering && isOver(*slot)) {
            if (!kept) kept.emplace(gl);
            gl.copy(slot->gathered, slot->buffer);
            enter(*slot, Slot::Stage::Copying);
        }
        if (slot->stage != Slot::Stage::Copying || !isOver(*slot)) continue;
        enter(*slot, Slot::Stage::Free);
        if (latest == nullptr || slot->number > latest->number) latest = slot.get();
    }
    if (latest == nullptr) return false;

    if (!kept) kept.emplace(gl);
    const auto size = static_cast<std::size_t>(gl.gridSize());
    reading.number = latest->number;
    reading.depths.resize(DepthGrid::Sides * size);
    gl.bindBuffer(GL_PIXEL_PACK_BUFFER, latest->buffer);
    gl.getBufferSubData(GL_PIXEL_PACK_BUFFER, 0,
                        static_cast<GLsizeiptr>(sizeof(float) * reading.depths.size()),
                        reading.depths.data());

    DepthGrid& grid = reading.grid;
    grid.columns = gl.across.count;
    grid.rows = gl.up.count;
    for (std::size_t side = 0; side < DepthGrid::Sides; ++side)
        grid.depths[side] = std::span(reading.depths).subspan(side * size, size);
    const auto width = static_cast<unsigned>(gl.width);
    const auto height = static_cast<unsigned>(gl.height);
    const Vec2 pixel(2.0 / width, 2.0 / height);
    grid.ndcFirst = {gl.across.ndcFirst(width), gl.up.ndcFirst(height)};
    grid.ndcStep = {pixel.x() * gl.across.step, pixel.y() * gl.up.step};
    grid.ndcBeside = {pixel.x() * gl.across.beside, pixel.y() * gl.up.beside};
    if (latest->isFlipped) // OGRE draws textures upside down
        for (Vec2* const vector : {&grid.ndcFirst, &grid.ndcStep, &grid.ndcBeside})
            vector->y() = -vector->y();
    grid.isReversed = latest->isReversed;
    grid.bits = gl.format.isFloat ? 24 : gl.format.bits;
    grid.isFloat = gl.format.isFloat;
    return true;
}

} // namespace Lixel
