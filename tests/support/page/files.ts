/** Ways to give files to the page: a button, a drop, the clipboard. */
import type {Page} from 'playwright-core';

import {begun, button} from './page.js';

export interface HandedFile {
  readonly name: string;
  readonly mimeType: string;
  readonly content: string;
}

export const jsonFile = (name: string, content: unknown): HandedFile => ({
  name,
  mimeType: 'application/json',
  content: typeof content === 'string' ? content : JSON.stringify(content),
});

/** Two squares sewn along one side, in GarmentCode's format. The length is in the file's unit. */
export function squares(side: number, unitsInMetre = 100): object {
  const vertices = [
    [0, 0],
    [side, 0],
    [side, side],
    [0, side],
  ];
  const edges = [0, 1, 2, 3].map((k) => ({endpoints: [k, (k + 1) % 4]}));
  return {
    pattern: {
      panels: {left: {vertices, edges}, right: {vertices, edges}},
      stitches: [
        [
          {panel: 'left', edge: 1},
          {panel: 'right', edge: 3},
        ],
      ],
    },
    properties: {curvature_coords: 'relative', units_in_meter: unitsInMetre},
  };
}

/** Chooses a file with a button. */
export async function choose(
  page: Page,
  name: string,
  {content, ...file}: HandedFile,
): Promise<void> {
  await begun(page);
  const [chooser] = await Promise.all([
    page.waitForEvent('filechooser'),
    button(page, name).click(),
  ]);
  await chooser.setFiles({...file, buffer: Buffer.from(content)});
}

/** Drops or pastes a file. */
export const hand = (page: Page, way: 'drop' | 'paste', file: HandedFile): Promise<void> =>
  page.evaluate(
    ([how, {name, mimeType, content}]) => {
      const data = new DataTransfer();
      data.items.add(new File([content], name, {type: mimeType}));
      const usual = {bubbles: true, cancelable: true};
      document.body.dispatchEvent(
        how === 'drop'
          ? new DragEvent('drop', {...usual, dataTransfer: data})
          : new ClipboardEvent('paste', {...usual, clipboardData: data}),
      );
    },
    [way, file] as const,
  );
