import type {StoredDesign} from '@/model/documents/stored-design.js';

/** A design with a value in every field. */
export const storedDesign: StoredDesign = {
  garment: {url: '../garments/tee m.json', sha256: '0f'.repeat(32), size: 'M, größer'},
  print: {
    url: 'https://shop.example/prints/cm.json?v=2',
    sha256: 'a1'.repeat(32),
    colourway: 'Night',
    group: 'cm',
    size: {width: 12, height: 9.25, angleDeg: 90},
    turnDeg: 90,
    oneWay: true,
    cell: 'rectangular',
  },
  symmetry: [
    {
      kind: 'piece',
      piece: 'front',
      axis: [
        [0, 0],
        [0, 40.5],
      ],
    },
    {kind: 'pair', pieces: ['sleeve_left', 'sleeve_right']},
  ],
  method: 'best',
  options: {
    maxChangeCm: 0.5,
    grain: {default: 'on', pieces: {front: {lock: 'free', toleranceDeg: 5}}},
    pins: {front: {angle: 0.1, translation: [1, -2]}},
    unmatched: [8, 9],
    plain: ['yoke'],
  },
  seed: 4294967295,
  names: {sleeve_left: 'Ärmel'},
  alignments: {
    front: {angle: 0.1, translation: [1, -2]},
    constructor: {angle: -3.1, translation: [0, 1e-9] as const},
  },
  result: '07'.repeat(32),
  solver: '1.20.3-rc.1',
};
