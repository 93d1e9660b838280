#pragma once
// Approval: candidates of the last run become goldens, only when a person asks.
#include "golden/result.hpp"

#include <span>
#include <string>
#include <vector>

namespace sr::golden {

struct ApproveOptions {
    std::filesystem::path output;    // of the run
    std::vector<std::string> names;  // patterns of tests of the last run; empty: all that did not pass
    std::vector<std::string> except; // patterns of tests that are left as they are
    std::filesystem::path review;    // what a person decided in the report (read_review()); empty: none
    std::filesystem::path laws;      // JUnit XML of law and truth tests; empty: the suite's, if it names one
    bool force = false;              // overcomes the refusals that are marked so
    std::string alternate;           // label: they become alternates, beside the goldens (suite.hpp)
};

/// Why a candidate is not to become a golden.
struct Refusal {
    std::string reason;
    bool yields_to_force = false;
};

/// The effect of approving a test.
struct Approval {
    std::string name;
    std::filesystem::path candidate;
    std::filesystem::path golden;
    std::string change; // "new", "equal", or what differs from the golden that it replaces
    std::vector<Refusal> refusals;
    std::string bytes;   // of the candidate; empty if there is none
    std::string sidecar; // JSON of who rendered it (sidecar_of()); empty where the picture itself says so
};

struct ApprovalPlan {
    std::vector<Approval> approvals;
    std::vector<std::string> remarks;

    /// True if nothing is refused, or only what `force` overcomes.
    bool is_allowed(bool force) const;
};

/// The results of law and truth tests, as `ctest -L 'law|analytic|truth' --output-junit laws.xml` writes
/// them.
struct LawRecord {
    int tests = 0;
    std::vector<std::string> failed; // names; a test that could not be run counts as failed

    /// The failed tests whose names begin with one of `guards`.
    std::vector<std::string> failed_among(std::span<const std::string> guards) const;
};

/// Reads the JUnit XML of any program (CTest, GoogleTest, pytest). @throws Error if the file is missing or
/// has no <testcase>.
LawRecord read_law_record(const std::filesystem::path& file);

/// A test whose picture a person has looked at.
struct ReviewedTest {
    std::string name;
    std::string candidate_sha256; // fingerprint of that picture
};

/// The decisions that the report exports.
struct Review {
    std::string suite; // its name
    std::vector<ReviewedTest> approved;
    std::vector<ReviewedTest> rejected;
};

/// Reads a file that the report exported. @throws Error with its place if it is none, or decides a test twice
Review read_review(const std::filesystem::path& file);

/// Plans an approval of tests that the last run made, not of those that it kept from an earlier one; writes
/// nothing. Refused without regard to force: a test that the last run did not
/// have, a candidate that is missing or is not the one that was compared (by its fingerprint), one with
/// pixels that are not finite where the test does not allow them, a picture other than the reviewed one, a
/// golden that is a Git LFS pointer. Refused unless forced: a failing pixel
/// known in closed form, a failing law or truth test, a renderer that is not the suite's reference (or, where
/// the suite names none, not the one that made the golden). An alternate is refused without regard to force
/// where there is no golden yet, or it does not say who rendered it, or the golden's renderer did.
/// @throws Error if there are no results, or they or the review are another suite's, or no test fits a name.
ApprovalPlan plan_approval(const Suite& suite, const ApproveOptions& options);

/// Writes the goldens of a plan, all or none: each is written beside its golden first. @throws Error.
void carry_out(const ApprovalPlan& plan);

} // namespace sr::golden
