#include "support/gl.hpp"

#include <cstdlib>
#include <gtest/gtest.h>

namespace sr::testing {
namespace {

/// Fails a test at its end if the driver had anything to say during it.
class Silence : public ::testing::EmptyTestEventListener {
public:
    explicit Silence(const gl::Context& context) : context_(context) {}

    void OnTestEnd(const ::testing::TestInfo&) override {
        const auto& messages = context_.debug_messages();
        for (; reported_ < messages.size(); ++reported_)
            ADD_FAILURE() << "OpenGL says: " << messages[reported_];
    }

private:
    const gl::Context& context_;
    std::size_t reported_ = 0;
};

std::unique_ptr<gl::Context> opened() {
    const char* name = std::getenv("STERADIAN_BACKEND");
    const auto backend = gl::backend_named(name ? name : "auto");
    auto context = gl::open_context({backend.value_or(gl::Backend::automatic), true});
    ::testing::UnitTest::GetInstance()->listeners().Append(new Silence(*context));
    return context;
}

} // namespace

gl::Context& context() {
    static const std::unique_ptr<gl::Context> shared = opened();
    return *shared;
}

} // namespace sr::testing
