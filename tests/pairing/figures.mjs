// Quality of seam suggestions: strips garments of their seams and compares the suggestions with
// them.

const keyOf = ({piece, edge}) => `${piece} ${edge}`;

/** Maps each edge of a garment to the edge it is sewn to. */
function matesOf({pieces, seams}) {
  const named = ({piece, edge}) => keyOf({piece: pieces[piece].name, edge});
  return new Map(
    seams.flatMap(({a, b}) => [
      [named(a), named(b)],
      [named(b), named(a)],
    ]),
  );
}

/** Sums of figures over garments. */
export class Figures {
  edges = 0;
  first = 0;
  amongThree = 0;
  seams = 0;
  sure = 0;
  sureRight = 0;

  /** Shares: partner ranked first, partner among three, correct sure seams, sure seams of all. */
  get shares() {
    const share = (part, whole) => part / Math.max(1, whole);
    return {
      first: share(this.first, this.edges),
      amongThree: share(this.amongThree, this.edges),
      sureRight: share(this.sureRight, this.sure),
      found: share(this.sureRight, this.seams),
    };
  }

  /** Adds the suggestions for a garment without some of its seams. */
  add(document, {edges, sure}) {
    const mates = matesOf(document);
    for (const {partners, ...edge} of edges) {
      const mate = mates.get(keyOf(edge));
      if (mate === undefined) continue; // it stays open
      const rank = partners.findIndex((partner) => keyOf(partner) === mate);
      this.edges++;
      this.first += rank === 0 ? 1 : 0;
      this.amongThree += rank >= 0 && rank < 3 ? 1 : 0;
      this.seams += 0.5;
    }
    for (const {a, b} of sure) {
      this.sure++;
      this.sureRight += mates.get(keyOf(a)) === keyOf(b) ? 1 : 0;
    }
  }
}

/** Seams with a lower likelihood are not suggested. */
const leastLikely = 0.15;

/**
 * Sews a garment by answering questions according to its file: the likeliest open seam each time;
 * mirror images are sewn automatically.
 * @param pairing  `likeliestSeams` and `mirrorImage` of web/src/pairing
 */
export function dialogue({likeliestSeams, mirrorImage}, document) {
  const pairs = document.seams.flatMap(({a, b}) => [
    [keyOf(a), keyOf(b)],
    [keyOf(b), keyOf(a)],
  ]);
  const mates = new Map(pairs);
  const isRight = ({a, b}) => mates.get(keyOf(a)) === keyOf(b);
  let garment = {...document, seams: []};
  let refused = [];
  const busy = new Set();
  const told = {seams: document.seams.length, questions: 0, sewn: 0, followed: 0, wrong: 0};
  const sew = ({a, b}) => {
    const seam = {a, b, sameDirection: false, weight: 1, matched: true};
    garment = {...garment, seams: [...garment.seams, seam]};
    for (const end of [a, b]) busy.add(keyOf(end));
  };
  for (;;) {
    const [seam] = likeliestSeams(garment, leastLikely, {refused});
    if (!seam) return told;
    told.questions++;
    if (!isRight(seam)) {
      refused = [...refused, [seam.a, seam.b]];
      continue;
    }
    sew(seam);
    told.sewn++;
    const [a, b] = [seam.a, seam.b].map((end) => mirrorImage(garment, end));
    if (!a || !b || keyOf(a) === keyOf(b) || busy.has(keyOf(a)) || busy.has(keyOf(b))) continue;
    sew({a, b});
    told.followed++;
    told.wrong += isRight({a, b}) ? 0 : 1;
  }
}
