/** The list of all shipped samples, for menus: public/samples.json. */
import {collection} from '../prints/collection.js';
import {printOf} from '../prints/print-files.js';
import {bodyOf, sizeNames} from './body.js';
import {wardrobe} from './wardrobe.js';

const lines = (entries: readonly object[]): string =>
  entries.map((entry) => `    ${JSON.stringify(entry)}`).join(',\n');

export function sampleList(): string {
  const garments = wardrobe.map((draft) => {
    const {name, title} = draft(bodyOf('m'));
    return {style: name, title, sizes: sizeNames};
  });
  const prints = collection.map((design) => ({name: design.id, ...printOf(design)}));
  return `{\n  "garments": [\n${lines(garments)}\n  ],\n  "prints": [\n${lines(prints)}\n  ]\n}\n`;
}
