// Lengths and times of layouts, a row for each platform.
import {fit, ms, share, table} from './table.mjs';

const head = [
  'garment, repeat',
  'platform',
  'pieces',
  'length cm',
  'area/length',
  'bound/length',
  'proven',
  'no print cm',
  'no print, area/length',
  'one factorisation, ms',
  'first layout',
  'whole',
  'no print, first',
  'no print, whole',
  'first, ms',
  'whole, ms',
  'no print, ms',
];

/** Returns whether both platforms found layouts of the same lengths. */
const areAlike = (one, other) => lengthsOf(one) === lengthsOf(other);
const lengthsOf = ({printed, free}) =>
  JSON.stringify(
    [printed, free].map(({bound, proven, shorter}) => [
      bound,
      proven,
      shorter.map(([, length]) => length),
    ]),
  );

const rowsOf = ({name, pieces, area, native, wasm}) =>
  [native, wasm].map((figures, k) => {
    const {printed, free} = figures;
    return [
      k === 0 ? name : '',
      k === 0 ? 'native' : areAlike(native, wasm) ? 'wasm, same lengths' : 'wasm, OTHER LENGTHS',
      pieces,
      fit(printed.length),
      share(area / printed.length),
      share(printed.bound / printed.length),
      printed.proven ? 'yes' : 'no',
      fit(free.length),
      share(area / free.length),
      printed.unit.toFixed(1),
      ...[printed, free].flatMap(({first, whole}) => [first.toFixed(1), whole.toFixed(1)]),
      ms(printed.milliseconds.first),
      ms(printed.milliseconds.whole),
      ms(free.milliseconds.whole),
    ];
  });

export const layoutTable = (rows) => table(head, rows.flatMap(rowsOf));
