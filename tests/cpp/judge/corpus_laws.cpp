#include "judge/corpus_laws.h"

#include <gtest/gtest.h>

#include <string>

namespace evenload::corpus {
namespace {

constexpr double kSameShare = 0.035;  // of times and lengths, of a case and its moved image

std::string text(Vec2 p) { return std::to_string(p.x) + ", " + std::to_string(p.y); }

}  // namespace

void expect_within_limits(const Case& pocket, const Toolpath& path,
                          const path_check::Findings& found) {
  EXPECT_EQ(path.report.termination, Termination::kComplete);
  EXPECT_LE(found.cut_engagement, pocket.engagement_angle + kMostOver)
      << found.cut_engagement / kDegree << " degrees at " << text(found.cut_engagement_at);
  EXPECT_LE(found.gouge, kDeepestGouge) << "at " << text(found.gouge_at);
  EXPECT_LE(found.left_share, kMostLeft) << "at " << text(found.left_at);
  // Between the bits of a tip links of some hundredths of a millimetre run beside cuts that posts
  // round: what they meet there is two micrometres thick.
  const double most_linked = pocket.name == "tip_of_micrometres" ? 2.5 * kDegree : kMostLinked;
  EXPECT_LE(found.link_engagement, most_linked)
      << found.link_engagement / kDegree << " degrees at " << text(found.link_engagement_at);
  EXPECT_EQ(found.bad_plunges, 0) << "at " << text(found.bad_plunge_at);
  EXPECT_LE(found.arc_mismatch, 5e-6);
  EXPECT_LE(found.largest_sweep, kPi * 1.001);
}

void expect_same_when_moved(const Case& original, const Toolpath& at_home, double angle,
                            bool mirrored, Vec2 shift) {
  SCOPED_TRACE(std::string(mirrored ? "mirrored, " : "") + "turned by " +
               std::to_string(angle / kDegree) + " degrees, shifted by " + text(shift));
  const Case pocket = moved(original, angle, mirrored, shift);
  const Toolpath path = clear(pocket, pocket.params());
  expect_within_limits(pocket, path, judge(pocket, path));
  EXPECT_NEAR(path.report.cutting_time, at_home.report.cutting_time,
              kSameShare * at_home.report.cutting_time);
  EXPECT_NEAR(path.report.cut_length, at_home.report.cut_length,
              kSameShare * at_home.report.cut_length);
}

void expect_same_bytes(const Toolpath& a, const Toolpath& b) {
  ASSERT_EQ(a.moves.size(), b.moves.size());
  for (std::size_t i = 0; i < a.moves.size(); ++i) {
    const Move &m = a.moves[i], &n = b.moves[i];
    ASSERT_EQ(m.kind, n.kind);
    for (const double Move::*number :
         {&Move::x, &Move::y, &Move::z, &Move::sweep, &Move::cx, &Move::cy, &Move::feed})
      ASSERT_EQ(m.*number, n.*number) << "move " << i;
  }
  EXPECT_EQ(a.report.termination, b.report.termination);
  EXPECT_TRUE(a.report.findings == b.report.findings);
}

}  // namespace evenload::corpus
