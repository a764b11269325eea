/**
 * A shirt with a button front, a yoke that reaches over the shoulders, a collar on a stand, and
 * long sleeves pleated into cuffs with links.
 */
import type {Point} from '../../src/model/geometry/vectors.js';
import type {Body} from './body.js';
import {length} from './curves.js';
import {onBothSides, sew, turnsOnBothSides, type Garment} from './panel.js';
import {collarPanel, standPanel} from './shirt-collar.js';
import {
  backNeckline,
  buttonStand,
  capEase,
  cuffPleats,
  cutOf,
  shirtBody,
  sleevesAndCuffs,
  tails,
  yokeShare,
} from './shirt-pieces.js';
export function draftShirt(body: Body): Garment {
  const cut = cutOf(body);
  const stand = standPanel(body, {
    back: length(backNeckline(body, cut)),
    yoke: length(cut.neckline.yoke),
    front: length(cut.neckline.body),
    buttonStand,
  });
  const collarSeam = stand.edges.find(({name}) => name === 'collar');
  if (!collarSeam) throw new Error('the stand carries a collar');
  // starts just above the hem, which is slightly higher here than at the edge
  const low = cut.halves.front.side.from[1] - tails.front + 1;
  const centreFront: readonly Point[] = [[0, low], cut.neckline.body.to];
  const armholes = (['front', 'back'] as const).flatMap((half) => {
    const title = half === 'front' ? 'Front' : 'Back';
    const share = yokeShare(cut, half);
    const notches = half === 'front' ? [0.5] : [0.5, 0.55];
    return [
      ...onBothSides(
        'armhole',
        `${title} armhole`,
        ['sleeve_*', `cap ${half}`],
        half === 'front' ? ['front_*', 'armhole'] : ['back', 'armhole *'],
        {ease: capEase[half] * (1 - share), notches},
      ),
      ...onBothSides(
        'armhole',
        `${title} armhole at the yoke`,
        ['sleeve_*', `cap ${half} yoke`],
        ['yoke', `armhole ${half} *`],
        {
          ease: capEase[half] * share,
          // the crown of the cap meets the top of the shoulder here
          ...(half === 'front' && {notches: [0]}),
        },
      ),
    ];
  });
  return {
    name: 'shirt',
    title: 'Shirt',
    panels: [
      ...shirtBody(body, cut),
      stand,
      collarPanel(body, length(collarSeam.curve)),
      ...sleevesAndCuffs(body, cut),
    ],
    seams: [
      ...onBothSides('side', 'Side seam', ['front_*', 'side'], ['back', 'side *'], {
        notches: [0.5],
      }),
      ...onBothSides('panel', 'Front yoke seam', ['front_*', 'yoke'], ['yoke', 'front *']),
      sew('panel', 'Back yoke seam', ['back', 'yoke'], ['yoke', 'back'], {notches: [0.5]}),
      ...armholes,
      ...onBothSides(
        'underarm',
        'Underarm',
        ['sleeve_*', 'underarm front'],
        ['sleeve_*', 'underarm back'],
      ),
      ...(['front', 'back'] as const).flatMap((half) =>
        onBothSides(
          'gathered',
          `Cuff, ${half} of the slit`,
          ['sleeve_*', `wrist ${half}`],
          ['cuff_*', `upper ${half}`],
          {gathers: cuffPleats},
        ),
      ),
      ...onBothSides('collar', 'Front neckline', ['front_*', 'neckline'], ['stand', 'front *']),
      ...onBothSides(
        'collar',
        'Neckline of the button stand',
        ['front_*', 'button stand'],
        ['stand', 'button stand *'],
      ),
      ...onBothSides(
        'collar',
        'Neckline of the yoke',
        ['yoke', 'neckline front *'],
        ['stand', 'yoke *'],
      ),
      sew('collar', 'Back neckline', ['yoke', 'neckline'], ['stand', 'back'], {notches: [0.5]}),
      sew('collar', 'Collar', ['collar', 'stand'], ['stand', 'collar'], {notches: [0.5]}),
    ],
    matches: [
      {
        name: 'Button front',
        a: {panel: 'front_left', line: centreFront},
        b: {panel: 'front_right', line: centreFront},
      },
    ],
    turns: turnsOnBothSides(
      ['stand', 'end *', 'collar'],
      'the collar is set back from the end of its stand',
    ),
    symmetries: [
      ['front_left', 'front_right'],
      ['back'],
      ['yoke'],
      ['stand'],
      ['collar'],
      ['sleeve_left', 'sleeve_right'],
      ['cuff_left', 'cuff_right'],
    ],
  };
}
