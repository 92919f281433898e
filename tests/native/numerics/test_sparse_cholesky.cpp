// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <thread>
#include <vector>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/numerics/sparse_cholesky.hpp"

namespace curveups {
namespace {

// Lower triangle of a Laplacian on an n x n grid plus shift.
SparseMatrix grid(int n, double shift) {
  std::vector<Eigen::Triplet<double>> entries;
  auto id = [n](int r, int c) { return r * n + c; };
  for (int r = 0; r < n; ++r) {
    for (int c = 0; c < n; ++c) {
      entries.emplace_back(id(r, c), id(r, c), 4 + shift);
      if (c + 1 < n) entries.emplace_back(id(r, c + 1), id(r, c), -1);
      if (r + 1 < n) entries.emplace_back(id(r + 1, c), id(r, c), -1);
    }
  }
  SparseMatrix a(n * n, n * n);
  a.setFromTriplets(entries.begin(), entries.end());
  return a;
}

TEST(SparseCholesky, SolvesWithSeveralRightHandSidesAndNewValues) {
  SparseCholesky cholesky;
  for (double shift : {0.1, 2.0}) {
    const SparseMatrix a = grid(30, shift);
    ASSERT_TRUE(cholesky.factorize(a));
    const Eigen::MatrixXd x = Eigen::MatrixXd::Random(900, 3);
    const Eigen::MatrixXd b = a.selfadjointView<Eigen::Lower>() * x;
    EXPECT_LT((cholesky.solve(b) - x).norm(), 1e-10 * x.norm());
  }
}

TEST(SparseCholesky, SaysWhatIsNotPositiveDefinite) {
  SparseCholesky cholesky;
  EXPECT_FALSE(cholesky.factorize(grid(10, -3)));
  SparseMatrix a = grid(10, 0);
  a.valuePtr()[7] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(cholesky.factorize(a));
  EXPECT_TRUE(cholesky.factorize(grid(10, 0)));  // and goes on to work
}

TEST(SparseCholesky, TwoAtOnceGiveTheSameBits) {
  const SparseMatrix a = grid(60, 0.01);
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(3600, -1, 1);
  auto solve = [&] {
    SparseCholesky cholesky;
    EXPECT_TRUE(cholesky.factorize(a));
    return Eigen::VectorXd(cholesky.solve(b));
  };
  const Eigen::VectorXd alone = solve();
  Eigen::VectorXd first, second;
  std::thread other([&] { first = solve(); });
  second = solve();
  other.join();
  EXPECT_EQ(first, alone);
  EXPECT_EQ(second, alone);
}

TEST(SparseCholesky, AnEliminationOrderIsOneWithLittleFill) {
  EXPECT_TRUE(elimination_order({}).empty());
  // A star: its centre, numbered first, would fill everything, so that it goes among the last two.
  std::vector<std::vector<int>> star(50);
  for (int v = 1; v < 50; ++v) star[0].push_back(v);
  std::vector<int> order = elimination_order(star);
  ASSERT_EQ(order.size(), 50u);
  EXPECT_TRUE(order[49] == 0 || order[48] == 0);
  std::sort(order.begin(), order.end());
  for (int k = 0; k < 50; ++k) EXPECT_EQ(order[k], k);
}

TEST(SparseCholesky, SolvesInTheOrderGiven) {
  const SparseMatrix a = grid(30, 0.1);
  std::vector<std::vector<int>> above(a.rows());
  for (int c = 0; c < a.cols(); ++c) {
    for (SparseMatrix::InnerIterator it(a, c); it; ++it) {
      if (it.row() > c) above[c].push_back(static_cast<int>(it.row()));
    }
  }
  const std::vector<int> order = elimination_order(above);
  Eigen::PermutationMatrix<Eigen::Dynamic> P(a.rows());
  for (int k = 0; k < a.rows(); ++k) P.indices()(order[k]) = k;
  SparseMatrix permuted(a.rows(), a.cols());
  permuted.selfadjointView<Eigen::Lower>() = a.selfadjointView<Eigen::Lower>().twistedBy(P);
  SparseCholesky cholesky(Ordering::as_given);
  ASSERT_TRUE(cholesky.factorize(permuted));
  for (int k = 0; k < a.rows(); ++k) EXPECT_EQ(cholesky.order()[k], k);
  const Eigen::VectorXd x = Eigen::VectorXd::Random(a.rows());
  const Eigen::VectorXd b = a.selfadjointView<Eigen::Lower>() * x;
  EXPECT_LT((P.transpose() * cholesky.solve(P * b) - x).norm(), 1e-10 * x.norm());
  // By L alone: x^T A x is the square of what its half of the solution is long.
  const Eigen::VectorXd half = cholesky.solve_lower(P * b);
  EXPECT_NEAR(half.squaredNorm(), x.dot(b), 1e-10 * x.dot(b));
  EXPECT_LT((P.transpose() * cholesky.solve_upper(half) - x).norm(), 1e-10 * x.norm());
}

// Entries below the diagonal of a factor in this order.
double fill_of(const std::vector<std::vector<int>>& above, const std::vector<int>& order) {
  const int count = static_cast<int>(above.size());
  std::vector<int> place(count);
  for (int k = 0; k < count; ++k) place[order[k]] = k;
  std::vector<std::set<int>> below(count);
  for (int v = 0; v < count; ++v) {
    for (int u : above[v]) {
      below[std::min(place[v], place[u])].insert(std::max(place[v], place[u]));
    }
  }
  double fill = 0;
  for (int k = 0; k < count; ++k) {
    fill += static_cast<double>(below[k].size());
    if (below[k].empty()) continue;
    const int parent = *below[k].begin();
    below[parent].insert(std::next(below[k].begin()), below[k].end());
  }
  return fill;
}

// A square of squares and their diagonals, numbered as irregularly as tiles are.
struct Squares {
  static constexpr int side = 70, count = side * side;
  std::vector<std::vector<int>> above{count};
  Places places{count, 2};

  Squares() {
    for (int i = 0; i < side; ++i) {
      for (int j = 0; j < side; ++j) {
        places.row(number(i, j)) << i, 0.9 * j;
        if (j + 1 < side) join(number(i, j), number(i, j + 1));
        for (int k = std::max(0, j - 1); i + 1 < side && k <= std::min(side - 1, j + 1); ++k) {
          join(number(i, j), number(i + 1, k));
        }
      }
    }
    for (std::vector<int>& list : above) std::sort(list.begin(), list.end());
  }
  static int number(int i, int j) { return (side * i + j) * 1237 % count; }
  void join(int a, int b) { above[std::min(a, b)].push_back(std::max(a, b)); }
};

void expect_all_once(std::vector<int> order) {
  std::sort(order.begin(), order.end());
  for (std::size_t v = 0; v < order.size(); ++v) ASSERT_EQ(order[v], static_cast<int>(v));
}

TEST(SparseCholesky, DissectionFillsLess) {
  const Squares graph;
  const std::vector<int> order = elimination_order(graph.above, graph.places);
  ASSERT_EQ(order.size(), graph.above.size());
  expect_all_once(order);
  EXPECT_LT(fill_of(graph.above, order),
            0.9 * fill_of(graph.above, elimination_order(graph.above)));
}

TEST(SparseCholesky, PlacesThatSayNothingDoNoHarm) {
  const Squares graph;
  const std::vector<int> by_degree = elimination_order(graph.above);
  Places places = graph.places;
  places(17, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(elimination_order(graph.above, places), by_degree);
  places.setZero();
  const std::vector<int> order = elimination_order(graph.above, places);
  expect_all_once(order);
  EXPECT_LE(fill_of(graph.above, order), fill_of(graph.above, by_degree));
}

// Of W x W blocks on the graph of squares, in the order of its elimination; enough operations for
// several subtrees.
SparseMatrix wide_matrix(const Squares& graph, double diagonal) {
  constexpr int W = 6;
  const std::vector<int> order = elimination_order(graph.above, graph.places);
  std::vector<int> place(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) place[order[k]] = static_cast<int>(k);
  std::vector<Eigen::Triplet<double>> entries;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int v = 0; v < Squares::count; ++v) {
    for (int r = 0; r < W; ++r) {
      entries.emplace_back(W * place[v] + r, W * place[v] + r, diagonal + number(random));
    }
    for (int u : graph.above[v]) {
      const int row = W * std::max(place[v], place[u]), column = W * std::min(place[v], place[u]);
      for (int r = 0; r < W * W; ++r) {
        entries.emplace_back(row + r % W, column + r / W, number(random));
      }
    }
  }
  SparseMatrix out(W * Squares::count, W * Squares::count);
  out.setFromTriplets(entries.begin(), entries.end());
  return out;
}

TEST(SparseCholesky, SubtreesAtOnceGiveTheSameBits) {
  const Squares graph;
  const SparseMatrix a = wide_matrix(graph, 40);
  const Eigen::MatrixXd x = Eigen::MatrixXd::Random(a.rows(), 2);
  const Eigen::MatrixXd b = a.selfadjointView<Eigen::Lower>() * x;
  const int before = thread_count();
  Eigen::MatrixXd alone;
  for (int threads : {1, 2, 3, 8}) {
    set_thread_count(threads);
    SparseCholesky cholesky(Ordering::as_given);
    for (int run = 0; run < 2; ++run) {
      ASSERT_TRUE(cholesky.factorize(a));
      const Eigen::MatrixXd solved = cholesky.solve(b);
      if (alone.size() == 0) alone = solved;
      EXPECT_EQ(solved, alone);
    }
  }
  set_thread_count(before);
  EXPECT_LT((alone - x).norm(), 1e-10 * x.norm());
  // CHOLMOD's own numbers, in an order of its own.
  SparseCholesky other;
  ASSERT_TRUE(other.factorize(a));
  EXPECT_LT((other.solve(b) - alone).norm(), 1e-10 * x.norm());
}

TEST(SparseCholesky, FindsWhatIsNotPositiveDefiniteInSubtreesAndAbove) {
  const Squares graph;
  const SparseMatrix sound = wide_matrix(graph, 40);
  SparseCholesky cholesky(Ordering::as_given);
  for (Eigen::Index at : {Eigen::Index{0}, sound.cols() / 3, sound.cols() - 1}) {
    SparseMatrix a = sound;
    a.coeffRef(at, at) = -1000;
    EXPECT_FALSE(cholesky.factorize(a)) << at;
    EXPECT_TRUE(cholesky.factorize(sound));
  }
}

TEST(SparseCholesky, CanBeStoppedAmongSubtrees) {
  const SparseMatrix a = wide_matrix(Squares(), 40);
  SparseCholesky cholesky(Ordering::as_given);
  cholesky.analyze(a);
  int asked = 0;
  const Progress progress = [&](const std::string&, double) { return ++asked < 3; };
  EXPECT_THROW(
      {
        const ProgressScope scope(progress);
        for (int k = 0; k < 1000; ++k) cholesky.factorize(a);
      },
      Cancelled);
  EXPECT_TRUE(cholesky.factorize(a));
}

TEST(NestedDissection, PartsAreSeparatedByHigherOnes) {
  const Squares graph;
  const std::vector<int> part = dissected_parts(graph.above, graph.places);
  const int last = *std::max_element(part.begin(), part.end());
  // The last part is the shortest way across, or little more.
  EXPECT_LE(std::count(part.begin(), part.end(), last), Squares::side + 5);
  // What hangs together without it, and all below it likewise.
  std::vector<int> group(part.size());
  const auto root = [&](int v) {
    while (group[v] != v) v = group[v] = group[group[v]];
    return v;
  };
  for (int top : {last, last - 1}) {
    std::iota(group.begin(), group.end(), 0);
    for (int v = 0; v < Squares::count; ++v) {
      for (int u : graph.above[v]) {
        if (part[v] < top && part[u] < top) group[root(u)] = root(v);
      }
    }
    std::map<int, int> size;
    for (int v = 0; v < Squares::count; ++v) {
      if (part[v] < top) ++size[root(v)];
    }
    ASSERT_GE(size.size(), top == last ? 2u : 3u);
    for (const auto& [own, vertices] : size) EXPECT_LT(vertices, 0.62 * Squares::count);
  }
}

TEST(NestedDissection, TakesGraphsInPiecesAndThoseThatCanNotBeDivided) {
  // Vertices without a neighbour.
  Squares graph;
  for (int v : {5, 17, 4000}) {
    graph.above[v].clear();
    for (std::vector<int>& list : graph.above) {
      list.erase(std::remove(list.begin(), list.end(), v), list.end());
    }
  }
  EXPECT_EQ(dissected_parts(graph.above, graph.places).size(), graph.above.size());
  // Everybody a neighbour of everybody.
  std::vector<std::vector<int>> all(300);
  for (int v = 0; v < 300; ++v) {
    for (int u = v + 1; u < 300; ++u) all[v].push_back(u);
  }
  for (int part : dissected_parts(all, Places::Random(300, 3))) EXPECT_GE(part, 0);
}

TEST(NestedDissection, CanBeStopped) {
  const Squares graph;
  bool stopped = false;
  const ProgressScope scope([&](const std::string&, double) { return !stopped; });
  EXPECT_EQ(dissected_parts(graph.above, graph.places).size(), graph.above.size());
  stopped = true;
  EXPECT_THROW(
      {
        for (int k = 0; k < 1000; ++k) dissected_parts(graph.above, graph.places);
      },
      Cancelled);
}

}  // namespace

}  // namespace curveups
