// Small files that ask for much: every command ends in seconds and in little memory, with an error
// or a refuted case that names the field and the limit.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <set>
#include "certify/checker/miss_tree.hpp"
#include "files/case_files.hpp"
#include "files/case_json.hpp"
#include "files/tree_file.hpp"
#include "process.hpp"

namespace ccdfuzz {
namespace {

using testing::HasSubstr;

/// Runs the program with 1 GB of memory and 30 s of processor time, after which it is killed.
Finished limited(const std::string& arguments) {
  return shell("ulimit -v 1048576; ulimit -t 30; \"$ccdfuzz\" " + arguments);
}

std::string digits(size_t count) {
  std::string text;
  for (size_t i = 0; i < count; ++i) text += static_cast<char>('1' + (i * i + 3 * i) % 9);
  return text;
}

/// A fraction below 1 with this many digits.
Rational fraction(size_t count) {
  return Rational(Integer("1" + digits(count - 1)), Integer("9" + digits(count - 1)));
}

MovingPatch<double> tensor8(double height, double up) {
  MovingPatch<double> patch;
  patch.shape = Shape::tensor(8, 8);
  for (int i = 0; i < patch.shape.control_count(); ++i) {
    patch.positions.emplace_back(i / 9 / 8.0, i % 9 / 8.0, height + i * i % 7 / 16.0);
    patch.velocities.emplace_back(0, 0, up);
  }
  return patch;
}

Query near_tensors() {
  return {{tensor8(0, 1), tensor8(1, -1)}, 1};
}

Query vertex_face() {
  Query query;
  query.patches[0] = {Shape::point(), {{0.1, 0.2, 1}}, {{0, 0, -1}}};
  query.patches[1] = {
      Shape::triangle(1), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}};
  query.t_max = 2;
  return query;
}

class Hostile : public testing::Test {
 protected:
  std::string file(const Case& value) const {
    const std::string path = folder_ / "case.json";
    write_text(path, to_json(value));
    return path;
  }
  std::string with_tree(const Query& query, const std::string& tree) const {
    const std::string path = folder_ / "case.json";
    TreeWriter trees(path);
    const Result<TreeRef> ref = trees.write(tree);
    EXPECT_TRUE(ref && trees.finish());
    Case value;
    value.query = query;
    value.truth.clear_until = Rational(1, 4);
    value.truth.clearance = MissTree{Rational(1, 4), *ref};
    return file(value);
  }
  ScratchFolder folder_;
};

/// What the limits of a file refuse, which limits.of_a_file draws near them, is far past them here.
TEST_F(Hostile, NumbersAndListsFarPastTheirLimitsAreNotRead) {
  Case polynomial, until, witness;
  polynomial.query = until.query = vertex_face();
  witness.query = near_tensors();
  polynomial.truth.contact_root = {std::vector<Integer>(120'000, 3), 0, fraction(200)};
  until.truth.clearance = LinearClearance{fraction(20'000), true};
  const Rational x = fraction(100'000);
  witness.truth.witness = Witness{x, {Uv<Rational>{x, x}, Uv<Rational>{x, x}}};
  std::string real = to_json(until);
  const std::string t_max = "\"t_max\":2", zeros(400'000, '0');
  real.replace(real.find(t_max), t_max.size(), "\"t_max\":\"0x" + zeros + "4." + zeros + "p0\"");
  for (const auto& [text, message] :
       {std::pair{to_json(polynomial),
                  "root.polynomial: has 120000 coefficients; the degree is at "
                  "most 16"},
        {to_json(until),
         "clear.until: has a numerator or denominator of 20000 digits; at most 5000 "
         "are read"},
        {to_json(witness), "witness.t: has a numerator or denominator of 100000 digits"},
        {real, "has 800006 characters; a number has at most 2000"}}) {
    write_text(folder_ / "case.json", text);
    for (const char* command : {"verify ", "query "}) {
      refused(limited(command + folder_ / "case.json"), message);
    }
  }
}

TEST_F(Hostile, TheLongestWitnessThatIsReadIsWithinTheWorkBudgetOrRefused) {
  Case value;
  value.query = near_tensors();
  const Rational x = fraction(kMaxRationalDigits);
  value.truth.witness = Witness{x, {Uv<Rational>{x, x}, Uv<Rational>{x, x}}};
  const std::string path = file(value);
  const Finished verified = failed(limited("verify " + path));
  EXPECT_THAT(verified.out, HasSubstr("unproven  truth.witness: exceeds the work budget"));
  refused(limited("query " + path), "truth.witness: exceeds the work budget");
}

TEST_F(Hostile, TheLongestTimeOfALinearClearanceIsChecked) {
  Case value;
  value.query = vertex_face();
  value.query.patches[0].positions[0][2] = 0x1p-1000;
  value.query.patches[0].velocities[0] = {0x1p-900, -0x1p-990, -0x1p-1000};
  value.truth.clearance = LinearClearance{fraction(kMaxRationalDigits), true};
  value.truth.clear_until = Rational(1, 2);
  const Finished verified = limited("verify " + file(value));
  EXPECT_THAT(verified.code, testing::AnyOf(0, 1)) << verified.err;
}

TEST_F(Hostile, AFileOfManyCasesThatNobodyDecidesIsLeftUndecidedAfterAWhile) {
  constexpr size_t kCases = 40;
  Case value;
  value.query = near_tensors();
  std::string cases;
  for (size_t i = 0; i < kCases; ++i) {
    value.query.t_max = 1 + static_cast<double>(i) / kCases;
    cases += to_json(value) + "\n";
  }
  const std::string path = folder_ / "cases.jsonl";
  write_text(path, cases);
  const std::string line = "query --methods tdibm --json " + path;
  std::set<std::string> outputs;
  for (const char* threads : {"1", "2"}) {
    const Finished asked = shell(fmt::format("\"$ccdfuzz\" {} --threads {}", line, threads));
    EXPECT_EQ(asked.code, 2) << asked.out;
    const size_t rows = json_lines(asked.out).size();
    EXPECT_GE(rows, 28U);
    EXPECT_LT(rows, kCases);
    EXPECT_THAT(asked.err, HasSubstr(fmt::format("{}:{}: this case and all after it are left "
                                                 "undecided: the default budget of a run",
                                                 path, rows + 1)));
    outputs.insert(asked.err.substr(asked.err.rfind("ccdfuzz: query: ")));  // after the progress
  }
  EXPECT_EQ(outputs.size(), 1U) << "depends on the number of threads";
  const Finished all = succeeded(shell("\"$ccdfuzz\" " + line + " --max-pops 10"));
  EXPECT_EQ(json_lines(all.out).size(), kCases);
}

/// This many cases with this truth, each of which takes seconds.
std::string costly_cases(size_t count, const Truth& truth) {
  Case value;
  value.query = near_tensors();
  value.truth = truth;
  std::string cases;
  for (size_t i = 0; i < count; ++i) cases += to_json(value) + "\n";
  return cases;
}

TEST_F(Hostile, AFileOfManyCostlyCertificatesEndsAtTheFirstCasePastTheLimitOfARun) {
  const Rational x = fraction(kMaxRationalDigits);
  Truth truth;
  truth.witness = Witness{x, {Uv<Rational>{x, x}, Uv<Rational>{x, x}}};
  const std::string path = folder_ / "cases.jsonl";
  write_text(path, costly_cases(200, truth));
  const std::string past =
      fmt::format("{}:2: checking the cases up to this one takes more than ", path);
  for (const char* threads : {"1", "2"}) {
    refused(limited(fmt::format("verify {} --threads {}", path, threads)), past);
  }
  refused(limited("replay " + path), past);
  refused(limited(fmt::format("verify {} --max-work 1000", path)),
          ":1: checking the cases up to this one takes more than 1000 ");
}

TEST_F(Hostile, EachCommandThatChecksCasesHasALimitOfARun) {
  const std::string path = generated(folder_, "FF", "RP", 2);
  for (const std::string& command : std::vector<std::string>{
           "verify", "replay", "query", "evaluate", "trace",
           "prove -o " + (folder_ / "proven.jsonl"), "triage -o " + (folder_ / "finds")}) {
    refused(limited(fmt::format("{} --max-work 10 {}", command, path)),
            ":1: checking the cases up to this one takes more than 10 ");
  }
}

TEST_F(Hostile, AFileOfManyAbsencesByWordEndsAtTheLimitOfARun) {
  Truth truth;
  truth.collides = false;
  truth.proof = "rational-tdibm";
  const std::string path = folder_ / "cases.jsonl";
  write_text(path, costly_cases(200, truth));
  refused(limited("verify --max-work 1000000000 --threads 1 " + path),
          ":1: checking the cases up to this one takes more than ");
}

TEST_F(Hostile, ManyCasesInAFewCompressedBytesEndAtALimitThatCountsBytes) {
  Truth truth;
  truth.collides = false;
  truth.proof = "rational-tdibm";
  const std::string path = folder_ / "cases.jsonl.zst";
  CaseWriter writer = CaseWriter::open(path).value();
  Case value;
  value.query = near_tensors();
  value.truth = truth;
  for (int i = 0; i < 5000; ++i) ASSERT_TRUE(writer.write(value));
  ASSERT_TRUE(writer.finish());
  EXPECT_LT(std::filesystem::file_size(path), 10'000U);
  refused(limited("verify " + path), "checking the cases up to this one takes more than ");
  for (const char* command :
       {"query --json --methods tdibm", "replay --json --methods tdibm --expect correct"}) {
    refused(
        shell(fmt::format("ulimit -v 1048576; ulimit -t 120; \"$ccdfuzz\" {} {}", command, path)),
        "this case and all after it are left undecided");
  }
}

/// In small numbers and nearer than planes tell apart, one of them moved by a large number.
Query tensors_of_far_exponents() {
  Query query = {{tensor8(0, 0), tensor8(0.25, 0)}, 1};
  for (MovingPatch<double>& patch : query.patches) {
    for (Vec3<double>& p : patch.positions) p *= 0x1p-600;
  }
  query.patches[0].velocities[0][0] = 0.5;
  return query;
}

TEST_F(Hostile, AnAbsenceByWordInNumbersFarApartIsUnprovenAfterTheWorkOfACase) {
  Case value;
  value.query = tensors_of_far_exponents();
  value.truth.collides = false;
  value.truth.proof = "rational-tdibm";
  const Finished verified = failed(limited("verify " + file(value)));
  EXPECT_THAT(verified.out, HasSubstr("unproven  no proof found within the work of a case"));
}

TEST_F(Hostile, AQueryOfNumbersFarApartIsLeftUndecidedByTheExactMethod) {
  Case value;
  value.query = tensors_of_far_exponents();
  const Finished asked = succeeded(limited("query --json --methods tdibm-rational " + file(value)));
  EXPECT_THAT(asked.out, HasSubstr("work budget exhausted"));
}

/// All leaves of a tree hold the same bits: "0 1".
TEST_F(Hostile, AWideTreeIsRefused) {
  TreeBits bits;
  const auto grow = [&](const auto& self, int left) -> void {
    if (left == 0) return bits.leaf({0, 0, 1});
    bits.split(left % 2);
    for (int c = 0; c < 4; ++c) self(self, left - 1);
  };
  grow(grow, 8);
  Query query = near_tensors();
  for (Vec3<double>& p : query.patches[1].positions) p[2] += 100;  // every leaf holds
  const Finished verified = failed(limited("verify " + with_tree(query, bits.bytes())));
  EXPECT_THAT(verified.out, HasSubstr("truth.certificate.clear.tree: exceeds the work budget"));
}

TEST_F(Hostile, ABoxOfExtremeNumbersIsChecked) {
  Case value;
  value.query = near_tensors();
  for (MovingPatch<double>& patch : value.query.patches) {
    for (Vec3<double>& p : patch.positions) p[0] += 0x1p-1074, p[1] = 0x1p1000;
  }
  ContactBox box;
  box.centre = {0x1p-1040 + 0x1p-1074, 0.5 + 0x1p-52, 0x1p-1039 + 0x1p-1074, 0x1p-1000, 0.5};
  box.varied = {0, 2, 4};
  box.radius = {0x1p-1050, 0x1p-1050, 0x1p-1050};
  box.inverse = {{{0x1p1000, 0x1p-1074, 0}, {0, 0x1p1000, 0}, {0, 0x1p-1074, 1}}};
  value.truth.contact_box = box;
  failed(limited("verify " + file(value)));
}

TEST_F(Hostile, ASignalIsObeyedWhateverTheProgramComputesOrWaitsFor) {
  Case value;
  value.query = near_tensors();
  const std::string path = file(value);
  // Nobody writes into these pipes.
  const ScratchFolder inputs;
  for (const char* pipe : {"edge-edge.csv", "pipe.jsonl"}) {
    ASSERT_EQ(::mkfifo((inputs / pipe).c_str(), 0600), 0);
  }
  for (const char* arguments :
       {"query {0} --methods trad,tdibm-rational --max-pops 1000000000", "prove {0} -o {0}.p.jsonl",
        "evaluate {0} --methods trad --max-pops 1000000000",
        "import {inputs}/edge-edge.csv -o {0}.i.jsonl", "verify {inputs}/pipe.jsonl"}) {
    const std::string line =
        fmt::format(fmt::runtime(arguments), path, fmt::arg("inputs", inputs.path()));
    const Finished finished =
        shell("timeout --preserve-status -k 10 1 \"$ccdfuzz\" " + line + " >&2");
    EXPECT_EQ(finished.code, 128 + SIGTERM) << line << finished.err;
  }
  EXPECT_EQ(folder_.entry_count(), 1U) << "a temporary file is left";
}

/// Edges without end, whose numbers have as many digits as a query's may.
TEST_F(Hostile, ASignalEndsAnImportThatComputes) {
  const std::string csv = folder_ / "edges.csv", out = folder_ / "out.jsonl";
  std::string rows;
  for (int i = 0; i < 8; ++i) {
    rows += fmt::format("{0},{1},{2},{1},{3},{1}\n", digits(900 + i), "1" + digits(900),
                        digits(899 - i), digits(890 + 2 * i));
  }
  write_text(csv, rows);
  ASSERT_EQ(limited(fmt::format("import --round {} --as edge-edge -o {}", csv, out)).code, 0);
  std::filesystem::remove(out);
  const Finished finished = shell(fmt::format(
      "while cat {}; do :; done 2>/dev/null | timeout --preserve-status -k 300 1 \"$ccdfuzz\" "
      "import --round /dev/stdin --as edge-edge -o {}",
      csv, out));
  EXPECT_EQ(finished.code, 128 + SIGTERM) << finished.err;
  EXPECT_EQ(folder_.entry_count(), 1U) << "a file is left, whole or not";
}

}  // namespace
}  // namespace ccdfuzz
