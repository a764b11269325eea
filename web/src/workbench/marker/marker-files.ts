/** Files of a marker. */
import {layPlanText} from '../../marker/plan.js';
import {planOfGarment} from '../../marker/garment-shares.js';
import {noPicture, printOf, type DesignPrint} from '../../model/design/design.js';
import {asCut} from '../../model/print/as-cut.js';
import type {LayPlan} from '../../model/result/marker-plan.js';
import {readable} from '../../model/garment/piece-names.js';
import type {MarkerTexts} from '../../texts/marker-texts.js';
import {planTextsIn} from '../../texts/plan-texts.js';
import {printName, withSampleNames} from '../../texts/sample-names.js';
import type {Workbench} from '../workbench.js';
import {embeddedTile, pixelsOfTile} from '../../image/embedded-tile.js';
import type {SolvedGarment} from './added-results.js';
import {letterOf, pieceLabel, titleOf} from './garment-words.js';
import {markerGarmentOf} from './lay-run.js';
import {drawnLetters} from '../cutting/drawn-letters.js';

interface MarkerFileChoice {
  readonly id: string;
  readonly title: string;
  /** Suffix of the file name. */
  readonly ending: string;
  /** @throws {Error} one sentence as its message */
  readonly make: () => Promise<Blob>;
}

/** A layout with the data for its files. */
interface Laid {
  readonly words: MarkerTexts;
  readonly workbench: Workbench;
  /** Print of the fabric. */
  readonly print: DesignPrint;
  /** All garments of the layout. */
  readonly garments: readonly SolvedGarment[];
}

type Titled = Laid & {
  /** Titles of the drawn garments. */
  readonly titles: readonly string[];
};

/** Returns the options for drawing a marker. @throws {Error} if the print's image cannot be read */
async function drawnWith({workbench: {preferences}, print, garments, titles}: Titled) {
  const {texts} = preferences;
  const tile = print.image === noPicture ? undefined : await embeddedTile(print.image);
  return {
    print: {
      ...{...asCut(printOf(print)), title: printName(print, preferences.texts)},
      ...(tile !== undefined && {tile}),
    },
    results: garments.map((one) => ({
      ...markerGarmentOf(one),
      garment: withSampleNames(one.document, one.design.garment.name, texts),
    })),
    title: titles.join('; '),
    names: (which: number, piece: string) => {
      const garment = garments[which];
      const label = garment ? pieceLabel(garment, piece, texts) : readable(piece);
      return garments.length > 1 ? `${letterOf(which)} ${label}` : label;
    },
    words: {
      units: preferences.chosen.units,
      locale: preferences.chosen.language,
      texts: planTextsIn(preferences.chosen.language),
    },
    pixels: (width: number, height: number) => pixelsOfTile(tile ?? '', width, height),
    letters: drawnLetters,
  };
}

const pdfOf = async (plan: LayPlan, laid: Titled, scale: 10 | 1): Promise<Blob> => {
  const {planPdf} = await import('../../marker/draw/plan-pdf.js');
  const {bytes} = await planPdf(plan, {...(await drawnWith(laid)), scale});
  return new Blob([bytes], {type: 'application/pdf'});
};

const dxfOf = async (plan: LayPlan, laid: Titled): Promise<Blob> => {
  const {planDxf} = await import('../../marker/draw/plan-dxf.js');
  const {words, ...drawn} = await drawnWith(laid);
  const dxf = planDxf(plan, {...drawn, texts: words.texts});
  return new Blob([dxf], {type: 'image/vnd.dxf'});
};

/** Returns the files of the whole layout, then those of each of several garments. */
export function markerFiles(plan: LayPlan, laid: Laid): readonly MarkerFileChoice[] {
  const {words, workbench, garments} = laid;
  const {texts} = workbench.preferences;
  const titles = garments.map((one, k) => {
    const title = titleOf(one, texts);
    return garments.length > 1 ? `${letterOf(k)} ${title}` : title;
  });
  const whole = {...laid, titles};
  return [
    {
      ...{id: 'pdf', title: words.savePdf, ending: 'layplan.pdf'},
      make: () => pdfOf(plan, whole, 10),
    },
    {
      ...{id: 'plotter', title: words.savePlotter, ending: 'layplan-1-1.pdf'},
      make: () => pdfOf(plan, whole, 1),
    },
    {
      ...{id: 'svg', title: words.saveSvg, ending: 'layplan.svg'},
      make: async () => {
        const {drawPlanSvg} = await import('../../marker/draw/draw-plan-svg.js');
        const drawn = drawPlanSvg(plan, await drawnWith(whole));
        return new Blob([drawn], {type: 'image/svg+xml'});
      },
    },
    {...{id: 'dxf', title: words.saveDxf, ending: 'layplan.dxf'}, make: () => dxfOf(plan, whole)},
    {
      ...{id: 'plan', title: words.savePlan, ending: 'layplan.json'},
      make: () => Promise.resolve(new Blob([layPlanText(plan)], {type: 'application/json'})),
    },
    ...(garments.length > 1
      ? titles.flatMap((title, k) => filesOfOne(planOfGarment(plan, k), whole, title, k))
      : []),
  ];
}

/** Files of one garment's pieces, each in its place on the fabric. */
function filesOfOne(
  plan: LayPlan,
  laid: Titled,
  title: string,
  which: number,
): readonly MarkerFileChoice[] {
  const {words} = laid;
  const alone = {...laid, titles: [title]};
  const letter = letterOf(which).toLowerCase();
  return [
    {
      ...{id: `pdf ${which}`, title: words.saveGarmentPdf(title)},
      ...{ending: `layplan-${letter}.pdf`, make: () => pdfOf(plan, alone, 10)},
    },
    {
      ...{id: `dxf ${which}`, title: words.saveGarmentDxf(title)},
      ...{ending: `layplan-${letter}.dxf`, make: () => dxfOf(plan, alone)},
    },
  ];
}
