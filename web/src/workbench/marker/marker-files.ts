/** Files of a marker. */
import {layPlanText} from '../../marker/plan.js';
import {decidedOf, noPicture, printOf, type DesignPrint} from '../../model/design/design.js';
import {garmentTitle, panelMarks} from '../../model/garment/panel-marks.js';
import type {LayPlan} from '../../model/result/marker-plan.js';
import {readable} from '../../model/garment/piece-names.js';
import type {MarkerTexts} from '../../texts/marker-texts.js';
import {planTextsIn} from '../../texts/plan-texts.js';
import {printName, withSampleNames} from '../../texts/sample-names.js';
import type {Workbench} from '../workbench.js';
import {embeddedTile, pixelsOfTile} from '../../image/embedded-tile.js';
import {drawnLetters} from '../cutting/drawn-letters.js';

interface MarkerFileChoice {
  readonly id: string;
  readonly title: string;
  /** Suffix of the file name. */
  readonly ending: string;
  /** @throws {Error} one sentence as its message */
  readonly make: () => Promise<Blob>;
}

/** Returns the options for drawing a marker. @throws {Error} if the print's image cannot be read */
async function drawnWith({history: {design}, solving, preferences}: Workbench, print: DesignPrint) {
  const {garment: document, result} = solving;
  const garment =
    document && design && withSampleNames(document, design.garment.name, preferences.texts);
  const tile = print.image === noPicture ? undefined : await embeddedTile(print.image);
  const marks = design && garment ? panelMarks(garment, decidedOf(design)) : undefined;
  const {title} = (garment && garmentTitle(garment, design.garment.name)) ?? {};
  return {
    print: {
      ...{...printOf(print), title: printName(print, preferences.texts)},
      ...(tile !== undefined && {tile}),
    },
    ...(result && {
      results: [
        {
          result,
          ...(garment && {garment}),
          ...(design && {options: design.options, names: design.names}),
        },
      ],
    }),
    ...(title !== undefined && {title}),
    names: (_: number, piece: string) => marks?.get(piece)?.label ?? readable(piece),
    words: {
      units: preferences.chosen.units,
      locale: preferences.chosen.language,
      texts: planTextsIn(preferences.chosen.language),
    },
    pixels: (width: number, height: number) => pixelsOfTile(tile ?? '', width, height),
    letters: drawnLetters,
  };
}

/** @param print print of the fabric */
export function markerFiles(
  plan: LayPlan,
  {
    words,
    workbench,
    print,
  }: {
    readonly words: MarkerTexts;
    readonly workbench: Workbench;
    readonly print: DesignPrint;
  },
): readonly MarkerFileChoice[] {
  const pdf = async (scale: 10 | 1): Promise<Blob> => {
    const {planPdf} = await import('../../marker/draw/plan-pdf.js');
    const {bytes} = await planPdf(plan, {...(await drawnWith(workbench, print)), scale});
    return new Blob([bytes], {type: 'application/pdf'});
  };
  return [
    {...{id: 'pdf', title: words.savePdf, ending: 'layplan.pdf'}, make: () => pdf(10)},
    {...{id: 'plotter', title: words.savePlotter, ending: 'layplan-1-1.pdf'}, make: () => pdf(1)},
    {
      ...{id: 'svg', title: words.saveSvg, ending: 'layplan.svg'},
      make: async () => {
        const {drawPlanSvg} = await import('../../marker/draw/draw-plan-svg.js');
        const drawn = drawPlanSvg(plan, await drawnWith(workbench, print));
        return new Blob([drawn], {type: 'image/svg+xml'});
      },
    },
    {
      ...{id: 'dxf', title: words.saveDxf, ending: 'layplan.dxf'},
      make: async () => {
        const {planDxf} = await import('../../marker/draw/plan-dxf.js');
        const {words: own, ...drawn} = await drawnWith(workbench, print);
        const dxf = planDxf(plan, {...drawn, texts: own.texts});
        return new Blob([dxf], {type: 'image/vnd.dxf'});
      },
    },
    {
      ...{id: 'plan', title: words.savePlan, ending: 'layplan.json'},
      make: () => Promise.resolve(new Blob([layPlanText(plan)], {type: 'application/json'})),
    },
  ];
}
