/** A garment large enough for a solve of several seconds. */
import type {GarmentCodeSpecification, Point} from 'seamwise/node';

/**
 * A skirt of gores whose hems are scallops of many short edges each; its seams run against the
 * grain.
 */
export function scallopedSkirt(gores: number, edges: number): GarmentCodeSpecification {
  const hem = Array.from({length: edges}, (_, k): Point => {
    const x = (40 * k) / edges - 20;
    return [x, 1.2 * Math.abs(Math.sin((Math.PI * x) / 5)) ** 2];
  });
  const vertices: Point[] = [...hem, [20, 0], [11, 48], [-11, 50]];
  const gore = {
    vertices,
    edges: vertices.map((_, k) => ({endpoints: [k, (k + 1) % vertices.length] as const})),
  };
  const name = (k: number) => `gore ${String(k)}`;
  const numbers = [...Array(gores).keys()];
  return {
    pattern: {
      panels: Object.fromEntries(numbers.map((k) => [name(k), gore])),
      stitches: numbers.slice(1).map((k) => [
        {panel: name(k - 1), edge: edges},
        {panel: name(k), edge: edges + 2},
      ]),
    },
    properties: {curvature_coords: 'relative', units_in_meter: 100},
  };
}
