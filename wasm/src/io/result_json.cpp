#include "io/result_json.h"

#include <algorithm>

#include "io/fold_json.h"
#include "io/json_ends.h"
#include "io/json_writer.h"

namespace seamwise {
namespace {

/// The panel's edge that contains each outline edge; edges follow each other along the outline.
std::vector<int> edgesOf(const Piece& piece) {
  std::vector<int> edges(piece.outline.size());
  const auto& start = piece.edge_start;
  for (std::size_t k = 0, edge = 0; k < edges.size(); ++k) {
    while (edge + 1 < start.size() && start[edge + 1] <= static_cast<int>(k)) ++edge;
    edges[k] = static_cast<int>(edge);
  }
  return edges;
}

const char* methodName(Method method) {
  switch (method) {
    case Method::kPaper:
      return "paper";
    case Method::kWs19:
      return "ws19";
    case Method::kBest:
      break;
  }
  return "best";
}

/// Writes the folds of a piece that take up fabric.
void writePleats(JsonWriter& out, std::vector<Fold> folds) {
  folds.erase(
      std::remove_if(folds.begin(), folds.end(), [](const Fold& fold) { return !fold.takesUp(); }),
      folds.end());
  if (folds.empty()) return;
  out.list("folds", folds, [&](const Fold& fold) {
    out.openObject();
    out.field("line", Polyline(fold.line.begin(), fold.line.end()));
    out.field("to", Polyline(fold.to.begin(), fold.to.end()));
    out.field("kind", foldKindName(fold.kind));
    out.close();
  });
}

void writePiece(JsonWriter& out, const PrintedPattern& printed, std::size_t p) {
  const Piece& piece = printed.pattern.pieces[p];
  out.field("name", piece.name);
  out.field("rest", piece.rest);
  out.field("shape", printed.shapes[p]);
  out.field("triangles", piece.triangles);
  out.field("outline", piece.outline);
  out.field("holes", piece.holes);
  out.field("alignment", printed.alignment[p]);
  out.field("mirroredFromInput", piece.mirrored_from_input);
  const Panel& panel = printed.garment.panels[p];
  out.field("grainAngle", panel.grain_angle);
  out.key("placement");
  out.openObject();
  out.field("translation", panel.placement_shift);
  out.field("rotation", panel.placement_turn);
  out.close();
  writePleats(out, panel.folds);
}

/// Writes the size, the body measurements and the matched lines of unsewn pieces.
void writeWearing(JsonWriter& out, const Garment& garment) {
  if (!garment.size.empty()) out.field("size", garment.size);
  if (!garment.body.empty()) {
    out.key("body");
    out.openObject();
    for (const BodyMeasure& measure : garment.body) out.field(measure.name, measure.cm);
    out.close();
  }
  if (garment.matches.empty()) return;
  out.list("matches", garment.matches, [&](const MatchLine& match) {
    const auto side = [&](const char* name, int piece, const Polyline& line) {
      out.key(name);
      out.openObject();
      out.field("piece", piece);
      out.field("line", line);
      out.close();
    };
    out.openObject();
    side("a", match.piece_a, match.a);
    side("b", match.piece_b, match.b);
    out.close();
  });
}

const char* reasonName(SeamReason reason) {
  switch (reason) {
    case SeamReason::kGrain:
      return "grain";
    case SeamReason::kGather:
      return "gather";
    case SeamReason::kGroup:
      return "group";
    case SeamReason::kSize:
      return "size";
    case SeamReason::kOthers:
      return "others";
    case SeamReason::kLocked:
      return "locked";
    case SeamReason::kNone:
      break;
  }
  return "";
}

const char* stateName(SeamState state) {
  switch (state) {
    case SeamState::kClose:
      return "close";
    case SeamState::kOff:
      return "off";
    case SeamState::kCannot:
      return "cannot";
    case SeamState::kChoice:
      return "choice";
    case SeamState::kMatches:
      break;
  }
  return "matches";
}

const char* endName(SeamEnd end) {
  switch (end) {
    case SeamEnd::kBottom:
      return "bottom";
    case SeamEnd::kLeft:
      return "left";
    case SeamEnd::kRight:
      return "right";
    case SeamEnd::kTop:
      break;
  }
  return "top";
}

void writeGroup(JsonWriter& out, const SeamGroup& group, const GroupFigures& figures) {
  std::vector<int> seams = group.seams;
  std::sort(seams.begin(), seams.end());
  out.openObject();
  out.field("seams", seams);
  out.field("place", placeName(group.place));
  if (group.side != BodySide::kMiddle)
    out.field("side", group.side == BodySide::kLeft ? "left" : "right");
  out.field("visibility", group.visibility);
  out.field("state", stateName(figures.state));
  if (figures.reason != SeamReason::kNone) out.field("reason", reasonName(figures.reason));
  if (figures.end) {
    out.key("unmatchedEnd");
    out.openObject();
    out.field("from", endName(figures.end->from));
    out.field("cm", figures.end->cm);
    out.close();
  }
  out.close();
}

void writeFigures(JsonWriter& out, const SeamFigures& of) {
  out.key("local");
  out.openObject();
  out.field("drafted", of.drafted);
  out.field("placed", of.placed);
  out.field("final", of.final);
  out.close();
  out.field("whole", of.whole);
  out.field("line", of.shaped ? "shaped" : "drafted");
  if (of.reason != SeamReason::kNone) out.field("why", reasonName(of.reason));
}

/// @param figures   figures of the seam; null before a solve
void writeSeam(JsonWriter& out, const PrintedPattern& printed, std::size_t s,
               const SeamFigures* figures) {
  const Seam& seam = printed.pattern.seams[s];
  const auto side = [&](const char* name, const SeamSide& of) {
    out.key(name);
    out.openObject();
    out.field("piece", of.piece);
    out.field("vertices", of.vertices);
    out.close();
  };
  out.openObject();
  side("a", seam.a);
  side("b", seam.b);
  out.field("weight", seam.weight);
  out.field("matched", seam.matched);
  out.field("lengthRatio", seam.length_ratio);
  out.field("kind", printed.joins[s].mirrored() ? "mirrored" : "continuous");
  out.field("mismatch", printed.mismatch[s]);
  if (figures) writeFigures(out, *figures);
  out.close();
}

void writeMirror(JsonWriter& out, const Pattern& pattern, const Mirror& m) {
  out.openObject();
  out.field("kind", m.single() ? "piece" : "pair");
  if (m.single())
    out.field("piece", m.pieces[0]);
  else
    out.field("pieces", std::array<int, 2>{m.pieces[0], m.pieces[1]});
  out.field("map", m.map);
  std::vector<std::array<int, 2>> pairs;
  for (const auto& loop : loopsOf(pattern.pieces[m.pieces[0]]))
    for (int v : loop) pairs.push_back({v, m.image[v]});
  out.field("pairs", pairs);
  out.close();
}

/// @param result   null before a solve: then every piece contains the panel's edge of each outline
///                 edge
void writePrinted(JsonWriter& out, const PrintedPattern& printed, const Result* result) {
  const Pattern& pattern = printed.pattern;
  out.key("print");
  out.openObject();
  out.field("group", printed.group);
  out.field("w1", printed.w1);
  out.field("w2", printed.w2);
  out.close();
  if (printed.continuous) out.field("continuousOnly", true);
  out.key("pieces");
  out.openList();
  for (std::size_t p = 0; p < pattern.pieces.size(); ++p) {
    out.openObject();
    writePiece(out, printed, p);
    if (!result) out.field("edges", edgesOf(pattern.pieces[p]));
    out.close();
  }
  out.close();
  out.key("seams");
  out.openList();
  for (std::size_t s = 0; s < pattern.seams.size(); ++s)
    writeSeam(out, printed, s, result ? &result->figures[s] : nullptr);
  out.close();
  out.list("symmetries", pattern.mirrors,
           [&](const Mirror& mirror) { writeMirror(out, pattern, mirror); });
  writeWearing(out, printed.garment);
}

/// Writes the sentences of notes, and their codes and values for translation.
void writeNotes(JsonWriter& out, const std::vector<Note>& notes) {
  out.list("notes", notes, [&](const Note& note) { out.put(note.text); });
  out.list("noteDetails", notes, [&](const Note& note) {
    out.openObject();
    out.field("code", note.code);
    out.field("pieces", note.pieces);
    out.field("seams", note.seams);
    out.field("numbers", note.numbers);
    out.close();
  });
}

void writeTotals(JsonWriter& out, const MismatchTotals& totals) {
  out.field("fitRandom", totals.total_random);
  out.field("fitDrafted", totals.total_drafted);
  out.field("fitSearch", totals.total_search);
  out.field("fitAligned", totals.total_aligned);
  out.field("fit", totals.total.nearest);
  out.field("fitStrict", totals.total.strict);
  out.field("fitSeam", totals.total.joined);
}

}  // namespace

std::string writeResult(const Result& r) {
  JsonWriter out;
  out.openObject();
  out.field("format", "seamwise-result/1");
  out.field("units", "cm");
  writePrinted(out, r, &r);
  out.key("seamGroups");
  out.openList();
  for (std::size_t g = 0; g < r.groups.size(); ++g) writeGroup(out, r.groups[g], r.states[g]);
  out.close();
  out.field("drafted", r.drafted);
  out.field("search", r.search);
  if (r.others)
    out.list("otherAlignments", *r.others, [&](const OtherAlignment& other) {
      out.openObject();
      out.field("pieces", other.pieces);
      out.field("placedCm", other.placed);
      out.field("expectedCm", other.expected);
      out.close();
    });
  out.key("metrics");
  out.openObject();
  out.field("method", methodName(r.method));
  out.field("seed", r.seed);
  writeTotals(out, r);
  if (r.continuous) {
    out.key("continuous");
    out.openObject();
    writeTotals(out, *r.continuous);
    out.close();
  }
  out.field("searchBound", r.search_bound);
  out.field("searchCost", r.search_cost);
  out.key("localCm");
  out.openObject();
  out.field("drafted", r.local.drafted);
  out.field("placed", r.local.placed);
  out.field("final", r.local.final);
  out.field("worst", r.local.worst);
  out.field("p90", r.local.p90);
  out.close();
  out.field("offCm", r.local.off);
  out.field("answerCost", r.cost);
  out.field("maxMovedCm", r.max_moved_cm);
  out.field("iterations", r.iterations);
  out.field("factorisations", r.factorisations);
  out.key("milliseconds");
  out.openObject();
  for (const char* phase : {"alignment", "deformation", "total"}) out.field(phase, 0);
  out.close();
  out.close();
  writeNotes(out, r.notes);
  out.close();
  return textOf(out.take());
}

std::string writePattern(const PrintedPattern& printed) {
  JsonWriter out;
  out.openObject();
  writePrinted(out, printed, nullptr);
  out.field("fitRandom", printed.total_random);
  writeNotes(out, printed.notes);
  out.close();
  return textOf(out.take());
}

}  // namespace seamwise
