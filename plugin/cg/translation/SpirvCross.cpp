#include "cg/translation/SpirvCross.h"

#include <spirv_cross/spirv_cross_c.h>

#include <charconv>
#include <memory>
#include <span>
#include <stdexcept>
#include <utility>

namespace Lixel::Cg {
namespace {

/// What SPIRV-Cross says when it cannot do something.
struct SpirvCrossError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

class SpirvCrossRun {
public:
    SpirvCrossRun(const Request& request, const std::vector<unsigned>& code) : mRequest(request) {
        spvc_context context = nullptr;
        if (spvc_context_create(&context) != SPVC_SUCCESS) throw SpirvCrossError("no memory");
        mContext.reset(context);
        spvc_parsed_ir program = nullptr;
        check(spvc_context_parse_spirv(context, code.data(), code.size(), &program));
        check(spvc_context_create_compiler(context, SPVC_BACKEND_GLSL, program,
                                           SPVC_CAPTURE_MODE_TAKE_OWNERSHIP, &mCompiler));
    }

    RawGlsl run() {
        setOptions();
        check(spvc_compiler_build_combined_image_samplers(mCompiler));
        check(spvc_compiler_create_shader_resources(mCompiler, &mResources));
        nameGlobals();
        nameTextures();
        mResult.inputs = nameInterface(SPVC_RESOURCE_TYPE_STAGE_INPUT, "lixel_in");
        mResult.outputs = nameInterface(SPVC_RESOURCE_TYPE_STAGE_OUTPUT, "lixel_out");
        const char* text = nullptr;
        check(spvc_compiler_compile(mCompiler, &text));
        mResult.text = text;
        return std::move(mResult);
    }

private:
    void check(spvc_result result) const {
        if (result != SPVC_SUCCESS)
            throw SpirvCrossError(spvc_context_get_last_error_string(mContext.get()));
    }

    void setOptions() {
        spvc_compiler_options options = nullptr;
        check(spvc_compiler_create_compiler_options(mCompiler, &options));
        const auto set = [&](spvc_compiler_option option, bool value) {
            check(spvc_compiler_options_set_bool(options, option, value ? SPVC_TRUE : SPVC_FALSE));
        };
        check(spvc_compiler_options_set_uint(options, SPVC_COMPILER_OPTION_GLSL_VERSION,
                                             mRequest.glslVersion));
        set(SPVC_COMPILER_OPTION_GLSL_ES, false);
        set(SPVC_COMPILER_OPTION_GLSL_VULKAN_SEMANTICS, false);
        set(SPVC_COMPILER_OPTION_GLSL_ENABLE_420PACK_EXTENSION, false);
        set(SPVC_COMPILER_OPTION_GLSL_SEPARATE_SHADER_OBJECTS, false);
        set(SPVC_COMPILER_OPTION_GLSL_EMIT_UNIFORM_BUFFER_AS_PLAIN_UNIFORMS, true);
        set(SPVC_COMPILER_OPTION_GLSL_ENABLE_ROW_MAJOR_LOAD_WORKAROUND, false);
        set(SPVC_COMPILER_OPTION_FIXUP_DEPTH_CONVENTION, false);
        set(SPVC_COMPILER_OPTION_FLIP_VERTEX_Y, false);
        check(spvc_compiler_install_compiler_options(mCompiler, options));
    }

    std::span<const spvc_reflected_resource> list(spvc_resource_type type) const {
        const spvc_reflected_resource* first = nullptr;
        std::size_t count = 0;
        check(spvc_resources_get_resource_list_for_type(mResources, type, &first, &count));
        return {first, count};
    }

    void nameGlobals() {
        const auto blocks = list(SPVC_RESOURCE_TYPE_UNIFORM_BUFFER);
        if (blocks.empty()) return;
        if (blocks.size() > 1) throw SpirvCrossError("constant buffers are not supported here");
        const spvc_reflected_resource& block = blocks.front();
        const spvc_type type = spvc_compiler_get_type_handle(mCompiler, block.base_type_id);
        const unsigned count = spvc_type_get_num_member_types(type);
        for (unsigned i = 0; i < count; ++i) {
            mResult.members.emplace_back(
                spvc_compiler_get_member_name(mCompiler, block.base_type_id, i));
            spvc_compiler_set_member_name(mCompiler, block.base_type_id, i,
                                          ("m" + std::to_string(i)).c_str());
            // OGRE's rows then are the columns that SPIR-V has them as.
            spvc_compiler_unset_member_decoration(mCompiler, block.base_type_id, i,
                                                  SpvDecorationRowMajor);
        }
        spvc_compiler_set_name(mCompiler, block.base_type_id, GlobalsType);
        spvc_compiler_set_name(mCompiler, block.id, GlobalsName);
    }

    void nameTextures() {
        const spvc_combined_image_sampler* pairs = nullptr;
        std::size_t count = 0;
        check(spvc_compiler_get_combined_image_samplers(mCompiler, &pairs, &count));
        for (const spvc_combined_image_sampler& pair : std::span(pairs, count)) {
            TextTexture texture;
            texture.texture = spvc_compiler_get_name(mCompiler, pair.image_id);
            texture.state = spvc_compiler_get_name(mCompiler, pair.sampler_id);
            texture.variable = "lixel_texture" + std::to_string(mResult.textures.size());
            spvc_compiler_set_name(mCompiler, pair.combined_id, texture.variable.c_str());
            mResult.textures.push_back(std::move(texture));
        }
        for (const spvc_reflected_resource& resource : list(SPVC_RESOURCE_TYPE_SAMPLED_IMAGE)) {
            bool isPair = false;
            for (const spvc_combined_image_sampler& pair : std::span(pairs, count))
                isPair = isPair || pair.combined_id == resource.id;
            if (isPair) continue;
            TextTexture texture;
            texture.texture = spvc_compiler_get_name(mCompiler, resource.id);
            texture.variable = "lixel_texture" + std::to_string(mResult.textures.size());
            spvc_compiler_set_name(mCompiler, resource.id, texture.variable.c_str());
            spvc_compiler_unset_decoration(mCompiler, resource.id, SpvDecorationBinding);
            mResult.textures.push_back(std::move(texture));
        }
    }

    std::vector<InterfaceVariable> nameInterface(spvc_resource_type kind, const char* prefix) {
        std::vector<InterfaceVariable> variables;
        for (const spvc_reflected_resource& resource : list(kind)) {
            InterfaceVariable variable;
            variable.variable = prefix + std::to_string(variables.size());
            variable.element = elementOf(spvc_compiler_get_name(mCompiler, resource.id));
            if (spvc_compiler_has_decoration(mCompiler, resource.id,
                                             SpvDecorationHlslSemanticGOOGLE) == SPVC_TRUE)
                variable.semantic = spvc_compiler_get_decoration_string(
                    mCompiler, resource.id, SpvDecorationHlslSemanticGOOGLE);
            readType(resource.type_id, variable);
            spvc_compiler_set_name(mCompiler, resource.id, variable.variable.c_str());
            spvc_compiler_unset_decoration(mCompiler, resource.id, SpvDecorationLocation);
            // GLSL 1.20 has no outputs of a fragment program with names: gl_FragData of that index.
            if (mRequest.glslVersion < 130 && mRequest.stage == Stage::Fragment &&
                kind == SPVC_RESOURCE_TYPE_STAGE_OUTPUT)
                spvc_compiler_set_decoration(mCompiler, resource.id, SpvDecorationLocation,
                                             static_cast<unsigned>(variables.size()));
            variables.push_back(std::move(variable));
        }
        return variables;
    }

    void readType(spvc_type_id id, InterfaceVariable& variable) const {
        const spvc_type type = spvc_compiler_get_type_handle(mCompiler, id);
        switch (spvc_type_get_basetype(type)) {
        case SPVC_BASETYPE_FP32:
            variable.base = InterfaceVariable::Base::Float;
            break;
        case SPVC_BASETYPE_INT32:
        case SPVC_BASETYPE_UINT32:
            variable.base = InterfaceVariable::Base::Int;
            break;
        case SPVC_BASETYPE_BOOLEAN:
            variable.base = InterfaceVariable::Base::Bool;
            break;
        default:
            throw SpirvCrossError("the type of the value with the semantic '" + variable.semantic +
                                  "' cannot go in or out of a program");
        }
        variable.components = spvc_type_get_vector_size(type);
        variable.columns = spvc_type_get_columns(type);
        const unsigned dimensions = spvc_type_get_num_array_dimensions(type);
        if (dimensions > 1)
            throw SpirvCrossError("arrays of arrays cannot go in or out of a program");
        if (dimensions == 1) variable.elements = spvc_type_get_array_dimension(type, 0);
    }

    /// 2 of "input.uv[2]", or 0.
    static unsigned elementOf(std::string_view name) {
        unsigned element = 0;
        const std::size_t bracket = name.rfind('[');
        if (name.ends_with(']') && bracket != std::string_view::npos)
            std::from_chars(name.data() + bracket + 1, name.data() + name.size(), element);
        return element;
    }

    struct Destroy {
        void operator()(spvc_context_s* context) const { spvc_context_destroy(context); }
    };
    const Request& mRequest;
    std::unique_ptr<spvc_context_s, Destroy> mContext;
    spvc_compiler mCompiler = nullptr;
    spvc_resources mResources = nullptr;
    RawGlsl mResult;
};

} // namespace

RawGlsl translateSpirv(const Request& request, const std::vector<unsigned>& code,
                       Messages& messages) {
    try {
        return SpirvCrossRun(request, code).run();
    } catch (const SpirvCrossError& error) {
        messages.push_back({Message::Kind::Error, request.file, 0, error.what()});
        return {};
    }
}

} // namespace Lixel::Cg
