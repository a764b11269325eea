/** A straight, collarless jacket of forty patches that meets edge to edge at the front. */
import type {Half} from './bodice.js';
import type {Body} from './body.js';
import {onBothSides, sew, type Garment, type Match, type Seam} from './panel.js';
import {
  bodyPatches,
  bodyRows,
  capEase,
  divisionOf,
  shoulderShare,
  sleevePatches,
  sleeveRows,
} from './patchwork-pieces.js';

const halves = ['front', 'back'] as const;
const titled = {front: 'Front', back: 'Back'} as const;

/** Each row with the one above it. */
const stacked = <Row>(rows: readonly Row[]): (readonly [Row, Row])[] =>
  rows.slice(1).map((above, k) => [rows[k] ?? above, above] as const);

function bodySeams(half: Half): Seam[] {
  const title = titled[half];
  // the back has one centre patch in each row, the front two
  const centre = (row: string): string =>
    half === 'front' ? `front_${row}_centre_*` : `back_${row}_centre`;
  const onCentre = half === 'front' ? 'column' : 'column *';
  const rows = stacked(bodyRows).flatMap(([below, above]) => {
    const name = `${title} ${below} row to ${above} row`;
    return [
      ...(half === 'front'
        ? onBothSides(
            'panel',
            `${name}, centre`,
            [centre(below), 'upper'],
            [centre(above), 'lower'],
          )
        : [sew('panel', `${name}, centre`, [centre(below), 'upper'], [centre(above), 'lower'])]),
      ...onBothSides(
        'panel',
        `${name}, side`,
        [`${half}_${below}_side_*`, 'upper'],
        [`${half}_${above}_side_*`, 'lower'],
      ),
    ];
  });
  const columns = bodyRows.flatMap((row) =>
    onBothSides(
      'panel',
      `${title} column, ${row} row`,
      [centre(row), onCentre],
      [`${half}_${row}_side_*`, 'column'],
    ),
  );
  return [...rows, ...columns];
}

function joiningSeams(body: Body): Seam[] {
  const sides = bodyRows
    .slice(0, 3)
    .flatMap((row) =>
      onBothSides(
        'side',
        `Side seam, ${row} row`,
        [`front_${row}_side_*`, 'side'],
        [`back_${row}_side_*`, 'side'],
      ),
    );
  const shoulders = [
    ...onBothSides(
      'shoulder',
      'Inner shoulder',
      ['front_shoulder_centre_*', 'shoulder'],
      ['back_shoulder_centre', 'shoulder *'],
    ),
    ...onBothSides(
      'shoulder',
      'Outer shoulder',
      ['front_shoulder_side_*', 'shoulder'],
      ['back_shoulder_side_*', 'shoulder'],
    ),
  ];
  const armholes = halves.flatMap((half) => {
    const share = shoulderShare(divisionOf(body, half));
    return (['chest', 'shoulder'] as const).flatMap((row) =>
      onBothSides(
        'armhole',
        `${titled[half]} armhole, ${row} row`,
        [`sleeve_cap_${half}_*`, `cap ${half} ${row}`],
        [`${half}_${row}_side_*`, 'armhole'],
        {
          ease: capEase[half] * (row === 'shoulder' ? share : 1 - share),
          ...(row === 'chest' && {notches: half === 'front' ? [0.6] : [0.55, 0.65]}),
        },
      ),
    );
  });
  return [...sides, ...shoulders, ...armholes];
}

function sleeveSeams(): Seam[] {
  const rows = stacked(sleeveRows).flatMap(([below, above]) =>
    halves.flatMap((half) =>
      onBothSides(
        'panel',
        `Sleeve ${below} row to ${above} row, ${half}`,
        [`sleeve_${below}_${half}_*`, 'upper'],
        [`sleeve_${above}_${half}_*`, 'lower'],
      ),
    ),
  );
  const along = sleeveRows.flatMap((row) => [
    ...onBothSides(
      'panel',
      `Overarm, ${row} row`,
      [`sleeve_${row}_front_*`, 'overarm'],
      [`sleeve_${row}_back_*`, 'overarm'],
    ),
    ...onBothSides(
      'underarm',
      `Underarm, ${row} row`,
      [`sleeve_${row}_front_*`, 'underarm'],
      [`sleeve_${row}_back_*`, 'underarm'],
    ),
  ]);
  return [...rows, ...along];
}

/** Matches of the two front edges, which are side by side when the jacket is closed. */
function frontEdges(garment: Pick<Garment, 'panels'>): Match[] {
  return bodyRows.map((row) => {
    const onEdge = (panel: string): Match['a'] => {
      const edges = garment.panels.find(({name}) => name === panel)?.edges ?? [];
      const found = edges.find(({name}) => name === 'front edge');
      if (!found) throw new Error(`no front edge on '${panel}'`);
      const {from, to} = found.curve;
      return {panel, line: from[1] < to[1] ? [from, to] : [to, from]};
    };
    return {
      name: `Front edge, ${row} row`,
      a: onEdge(`front_${row}_centre_left`),
      b: onEdge(`front_${row}_centre_right`),
    };
  });
}

export function draftPatchworkJacket(body: Body): Garment {
  const panels = [...bodyPatches(body), ...sleevePatches(body)];
  const pair = (name: string): readonly [string, string] => [`${name}_left`, `${name}_right`];
  return {
    name: 'patchwork-jacket',
    title: 'Patchwork jacket',
    panels,
    seams: [...bodySeams('front'), ...bodySeams('back'), ...joiningSeams(body), ...sleeveSeams()],
    matches: frontEdges({panels}),
    symmetries: [
      ...bodyRows.flatMap((row) => [
        pair(`front_${row}_centre`),
        pair(`front_${row}_side`),
        [`back_${row}_centre`] as const,
        pair(`back_${row}_side`),
      ]),
      ...sleeveRows.flatMap((row) => halves.map((half) => pair(`sleeve_${row}_${half}`))),
    ],
  };
}
