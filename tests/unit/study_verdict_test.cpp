// SPDX-License-Identifier: Apache-2.0
#include "study/verdict.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"

using namespace lobe;

namespace {

Judgement judge_one(const PairedRatios& thing) { return judge({thing}).front(); }

// Ratios that scatter evenly around `ratio`, by `spread` in the logarithm.
PairedRatios evenly(double ratio, double spread, int seeds = 20) {
    PairedRatios thing;
    for (int s = 0; s < seeds; ++s)
        thing.log_ratios.push_back(std::log(ratio) +
                                   spread * (2.0 * s / static_cast<double>(seeds - 1) - 1));
    return thing;
}

// What an experiment sees: the errors and times of both arms vary log-normally. `shared` is the
// part of the errors' variance that both arms share, through common random numbers.
struct Noise {
    double error = 0.05, time = 0.07, shared = 0;
};
PairedRatios simulate(Random& random, double ratio, int seeds, const Noise& noise) {
    PairedRatios thing;
    thing.timing_noise = noise.time;
    const double own = noise.error * std::sqrt(1 - noise.shared);
    for (int s = 0; s < seeds; ++s)  // what is shared goes away in the difference
        thing.log_ratios.push_back(std::log(ratio) + own * (random.normal() - random.normal()) +
                                   noise.time * (random.normal() - random.normal()));
    return thing;
}

struct Shares {
    double win = 0, loss = 0, tie = 0, significant = 0;
};
Shares simulate_many(double ratio, int seeds, const Noise& noise, int trials = 2000) {
    Random random(11);
    Shares shares;
    for (int t = 0; t < trials; ++t) {
        const Judgement j = judge_one(simulate(random, ratio, seeds, noise));
        shares.win += j.verdict == Verdict::win;
        shares.loss += j.verdict == Verdict::loss;
        shares.tie += j.verdict == Verdict::tie;
        shares.significant += j.p < 0.05;
    }
    for (double* share : {&shares.win, &shares.loss, &shares.tie, &shares.significant})
        *share /= trials;
    return shares;
}

}  // namespace

TEST(Verdict, FollowsTheInterval) {
    EXPECT_EQ(judge_one(evenly(1.2, 0.05)).verdict, Verdict::win);
    EXPECT_EQ(judge_one(evenly(0.8, 0.05)).verdict, Verdict::loss);
    EXPECT_EQ(judge_one(evenly(1.0, 0.01)).verdict, Verdict::tie);
    EXPECT_EQ(judge_one(evenly(1.0, 0.2)).verdict, Verdict::undecided);
    EXPECT_EQ(judge_one(evenly(1.02, 0.01)).verdict, Verdict::undecided);  // on the border
    EXPECT_EQ(judge_one(evenly(1.01, 0.005)).verdict, Verdict::tie);  // real, but of no account
    EXPECT_LT(judge_one(evenly(1.01, 0.005)).p, 0.001);
}

TEST(Verdict, TheIntervalIsStudents) {
    // Deviation of 0, 1, 2, 3, 4, 5 is 1.8708, t of 5 degrees 2.5706.
    const Judgement j = judge_one({{0, 1, 2, 3, 4, 5}});
    const double half = 2.570582 * 1.870829 / std::sqrt(6);
    EXPECT_NEAR(std::log(j.ratio), 2.5, 1e-9);
    EXPECT_NEAR(std::log(j.lo), 2.5 - half, 1e-5);
    EXPECT_NEAR(std::log(j.hi), 2.5 + half, 1e-5);
    EXPECT_NEAR(j.p, 0.0222, 1e-4);              // t = 3.2733
    EXPECT_NEAR(j.wilcoxon_p, 2.0 / 32, 1e-12);  // five differences, all of one sign
}

// Both tests must agree: the ranks of five differences cannot.
TEST(Verdict, RanksMustAgree) {
    PairedRatios thing = evenly(1.5, 0.01, 6);
    EXPECT_EQ(judge_one(thing).verdict, Verdict::win);
    thing.log_ratios[0] = 0;
    thing.log_ratios[1] = 0;
    const Judgement j = judge_one(thing);
    EXPECT_GT(j.wilcoxon_p, 0.05);
    EXPECT_NE(j.verdict, Verdict::win);
}

TEST(Verdict, TheSameThingIsATie) {
    const Judgement j = judge_one({std::vector<double>(20, 0.0)});
    EXPECT_EQ(j.verdict, Verdict::tie);
    EXPECT_EQ(j.ratio, 1);
    EXPECT_EQ(j.p, 1);
}

TEST(Verdict, Refusals) {
    PairedRatios thing = evenly(1.2, 0.05);
    thing.timing_noise = 0.16;
    EXPECT_EQ(judge_one(thing).verdict, Verdict::refused);
    EXPECT_NE(judge_one(thing).reason.find("16 %"), std::string::npos);
    EXPECT_GT(judge_one(thing).ratio, 1.1);  // told all the same
    thing.timing_noise = 0.149;
    EXPECT_EQ(judge_one(thing).verdict, Verdict::win);
    thing.log_ratios[3] = NAN;
    EXPECT_EQ(judge_one(thing).verdict, Verdict::refused);
    EXPECT_TRUE(std::isnan(judge_one(thing).ratio));
    EXPECT_EQ(judge_one(evenly(1.2, 0.01, 5)).verdict, Verdict::refused);
    EXPECT_EQ(judge_one({{}, 0, "why"}).reason, "why");
    EXPECT_EQ(judge_one(PairedRatios()).verdict, Verdict::refused);
}

// Deviation .0707, of two errors of 5 % each: (2.8016 * .0707 / .04879)^2 = 16.5.
TEST(Verdict, SeedsNeeded) {
    Random random(3);
    PairedRatios thing;
    for (int s = 0; s < 200; ++s) thing.log_ratios.push_back(random.normal());
    const Judgement raw = judge_one(thing);
    for (double& d : thing.log_ratios) d = (d - std::log(raw.ratio)) / raw.deviation * 0.0707107;
    thing.log_ratios.resize(200);
    EXPECT_EQ(judge_one(thing).seeds_for_5_percent, 17);
    EXPECT_FALSE(judge_one(thing).seeds_needed);  // 200 decide: a tie
    for (double& d : thing.log_ratios) d *= 3;
    EXPECT_EQ(judge_one(thing).verdict, Verdict::undecided);
    const double root = 2.801585 * 3 * 0.0707107 / std::log(1.02);
    EXPECT_NEAR(*judge_one(thing).seeds_needed, root * root, 1);
}

// The acceptance: a thing against itself, with realistic noise.
TEST(Verdict, EqualThingsSeldomWinOrLose) {
    for (const Noise& noise : {Noise{}, Noise{0.05, 0}, Noise{0.2, 0.07}, Noise{0.01, 0}}) {
        const Shares shares = simulate_many(1, 20, noise);
        EXPECT_LE(shares.win + shares.loss, 0.05);
        EXPECT_NEAR(shares.significant, 0.05, 4 * std::sqrt(0.05 * 0.95 / 2000));
    }
    EXPECT_GT(simulate_many(1, 20, {0.01, 0}).tie, 0.99);
}

// Normal theory for a difference of 5 % with errors of 5 %: .50, .82, .98 at 10, 20, 40 seeds;
// common random numbers with a correlation of .8 make it .99 at 10.
TEST(Verdict, PowerToSeeFivePercent) {
    EXPECT_NEAR(simulate_many(1.05, 10, {0.05, 0}).significant, 0.50, 0.05);
    EXPECT_NEAR(simulate_many(1.05, 20, {0.05, 0}).significant, 0.82, 0.04);
    EXPECT_NEAR(simulate_many(1.05, 40, {0.05, 0}).significant, 0.98, 0.02);
    EXPECT_GT(simulate_many(1.05, 10, {0.05, 0, 0.8}).significant, 0.97);
    EXPECT_NEAR(simulate_many(1.05, 17, {0.05, 0}).significant, 0.76, 0.05);  // .8 less Student's
}

TEST(Verdict, PowerToCallTheWinner) {
    EXPECT_GT(simulate_many(1.10, 20, {0.05, 0}).win, 0.97);
    EXPECT_GT(simulate_many(1.10, 20, {0.05, 0.07}).win, 0.65);
    EXPECT_GT(simulate_many(1 / 1.10, 20, {0.05, 0}).loss, 0.97);
    EXPECT_EQ(simulate_many(1.10, 20, {0.05, 0}).loss, 0);
}

TEST(Verdict, HolmOverScenes) {
    // p of about .013: enough alone, too much as the smallest of five.
    const PairedRatios weak = evenly(1.06, 0.155);
    const Judgement alone = judge_one(weak);
    EXPECT_LT(alone.p, 0.05);
    std::vector<PairedRatios> five(5, evenly(1, 0.3));
    five[2] = weak;
    const Judgement among = judge(five)[2];
    EXPECT_NEAR(among.p_holm, 5 * among.p, 1e-12);
    EXPECT_DOUBLE_EQ(among.lo, alone.lo);
    EXPECT_LT(among.lo_family, alone.lo_family);
    // A clear win stays one, and a family of nulls is seldom alarmed.
    five[2] = evenly(1.3, 0.1);
    EXPECT_EQ(judge(five)[2].verdict, Verdict::win);
}

TEST(Verdict, FamiliesOfEqualThingsSeldomWinOrLose) {
    Random random(13);
    int alarms = 0;
    for (int trial = 0; trial < 1000; ++trial) {
        std::vector<PairedRatios> family;
        for (int i = 0; i < 5; ++i) family.push_back(simulate(random, 1, 20, {0.2, 0.07}));
        bool alarm = false;
        for (const Judgement& j : judge(family))
            alarm |= j.verdict == Verdict::win || j.verdict == Verdict::loss;
        alarms += alarm;
    }
    EXPECT_LE(alarms, 50 + 4 * 7);
}

TEST(Verdict, CombinedIsTheGeometricMean) {
    const PairedRatios all = combined({evenly(2, 0.1), evenly(0.5, 0.1), evenly(1.331, 0.1)});
    const Judgement j = judge_one(all);
    EXPECT_NEAR(j.ratio, 1.1, 1e-3);
    EXPECT_EQ(j.verdict, Verdict::win);
    PairedRatios noisy = evenly(2, 0.1);
    noisy.timing_noise = 0.2;
    EXPECT_EQ(judge_one(combined({evenly(2, 0.1), noisy})).verdict, Verdict::refused);
    EXPECT_EQ(judge_one(combined({})).verdict, Verdict::refused);
}
