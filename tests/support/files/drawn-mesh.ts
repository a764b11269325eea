/** Garments as meshes with texture coordinates, in the format of simulators. */

/** A panel by its rim, counter-clockwise, and the positions of its points in space. [m] */
interface MeshPanel {
  readonly name: string;
  readonly rim: readonly (readonly [number, number])[];
  readonly placed: readonly (readonly [number, number, number])[];
}

export interface MeshHabits {
  /** Names `g NAME` before the faces of a panel. */
  readonly grouped?: boolean;
  /** A texture coordinate for every corner of a face. */
  readonly unwelded?: boolean;
  /** Negative indices. */
  readonly relative?: boolean;
  /** Factors of the texture coordinates, across and up. */
  readonly flatScale?: readonly [number, number];
  /** Numbers of the panels that are face down in the texture. */
  readonly mirrored?: readonly number[];
  /** Faces with as many corners as the panel, without a middle. */
  readonly polygons?: boolean;
}

type Triple = readonly [number, number, number];

/** A fan of triangles around the middle of every panel. */
function meshText(panels: readonly MeshPanel[], habits: MeshHabits = {}): string {
  const {flatScale: [across, up] = [1, 1], mirrored = []} = habits;
  const places: string[] = [];
  const lines: string[] = ['# drawn'];
  const flatLines: string[] = [];
  const faces: string[] = [];
  const vertex = (p: Triple): number => {
    const text = p.map((value) => value.toFixed(6)).join(' ');
    const known = places.indexOf(text);
    if (known >= 0) return known;
    return places.push(text) - 1;
  };
  const flat = (k: number, [x, y]: readonly [number, number]): number =>
    flatLines.push(`vt ${(mirrored.includes(k) ? -across : across) * x} ${up * y}`) - 1;
  panels.forEach(({name, rim, placed}, k) => {
    if (habits.grouped) faces.push(`g ${name}`);
    const corners = placed.map(vertex);
    const flats = rim.map((p) => flat(k, p));
    const again = (n: number, p: readonly [number, number]): number =>
      habits.unwelded ? flat(k, p) : n;
    const middle = rim.reduce(([a, b], [x, y]) => [a + x / rim.length, b + y / rim.length], [0, 0]);
    const lifted = placed.reduce<Triple>(
      ([a, b, c], [x, y, z]) => [a + x / rim.length, b + y / rim.length, c + z / rim.length],
      [0, 0, 0],
    );
    if (habits.polygons) {
      faces.push(['f', ...corners.map((v, n) => `${v}/${flats[n] ?? 0}`)].join(' '));
      return;
    }
    const [centre, flatCentre] = [vertex(lifted), flat(k, middle)];
    corners.forEach((v, n) => {
      const m = (n + 1) % corners.length;
      const own = again(flats[n] ?? 0, rim[n] ?? [0, 0]);
      const next = again(flats[m] ?? 0, rim[m] ?? [0, 0]);
      const c = again(flatCentre, middle);
      faces.push(`f ${v}/${own} ${corners[m] ?? 0}/${next} ${centre}/${c}`);
    });
  });
  const numbered = faces.map((face) =>
    face.replaceAll(/(\d+)\/(\d+)/g, (_, v: string, t: string) =>
      habits.relative
        ? `${Number(v) - places.length}/${Number(t) - flatLines.length}`
        : `${Number(v) + 1}/${Number(t) + 1}`,
    ),
  );
  return [...lines, ...flatLines, ...places.map((p) => `v ${p}`), ...numbered, ''].join('\n');
}

/** Half of a tunic, 50 by 60 cm, sewn to the other half at its sides and shoulders. [m] */
function half(name: string, depth: number): MeshPanel {
  const steps = (from: number, to: number, count: number): number[] =>
    Array.from({length: count}, (_, k) => from + ((to - from) * k) / count);
  const rim = [
    ...steps(0, 0.5, 10).map((x) => [x, 0] as const),
    ...steps(0, 0.6, 12).map((y) => [0.5, y] as const),
    ...steps(0.5, 0.35, 3).map((x) => [x, 0.6] as const),
    // the neck
    ...steps(0, Math.PI, 12).map(
      (turn) => [0.25 + 0.1 * Math.cos(turn), 0.6 - 0.1 * Math.sin(turn)] as const,
    ),
    ...steps(0.15, 0, 3).map((x) => [x, 0.6] as const),
    ...steps(0.6, 0, 12).map((y) => [0, y] as const),
  ];
  const isSewn = ([x, y]: readonly [number, number]): boolean =>
    x < 1e-9 || x > 0.5 - 1e-9 || y > 0.6 - 1e-9;
  const placed = rim.map((p) => [p[0], p[1], isSewn(p) ? 0 : depth] as const);
  return {name, rim, placed};
}

const front = half('front', 0.03);
const back = half('back', -0.03);
/** Seen from behind: face up, left and right are exchanged. */
const turned: MeshPanel = {
  ...back,
  rim: back.rim.map(([x, y]) => [2 - x, y] as const).reverse(),
  placed: [...back.placed].reverse(),
};
/** Front and back of the tunic. */
export const tunic = (habits: MeshHabits = {}): string => meshText([front, turned], habits);
