#include "support/address.hpp"

#include "core/error.hpp"

#include <string>

namespace sr::testing {
namespace {

class Addressed : public ::testing::Test {
public:
    explicit Addressed(sr::testing::Test::Body body) : body_(body) {}
    void TestBody() override { body_(); }

private:
    sr::testing::Test::Body body_;
};

} // namespace

Test::Test(std::string_view address, Body body, std::source_location here) {
    const auto dot = address.rfind('.');
    require(dot != std::string_view::npos, "a test's address has at least two words", here);
    const std::string suite(address.substr(0, dot));
    const std::string name(address.substr(dot + 1));
    ::testing::RegisterTest(suite.c_str(), name.c_str(), nullptr, nullptr, here.file_name(),
                            static_cast<int>(here.line()),
                            [body]() -> ::testing::Test* { return new Addressed(body); });
}

} // namespace sr::testing
