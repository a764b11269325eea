/** Puts the page together. */
import {
  keepPreferences,
  loadSamples,
  opening,
  sampleGarment,
  samplePrint,
  storedPreferences,
  Workbench,
} from '../element/index.js';
import {SeamwisePage} from './page.js';

const desk = new Workbench({}, storedPreferences());
keepPreferences(desk);
const page = new SeamwisePage();
page.desk = desk;
document.body.append(page);

const [samples, garment] = await Promise.all([
  loadSamples(),
  sampleGarment(opening.style, opening.size),
]);
page.samples = samples;
const print = samples.prints.find(({name}) => name === opening.print) ?? samples.prints[0];
if (print) {
  const design = {
    garment,
    print: samplePrint(print),
    symmetries: [],
    method: 'best' as const,
    options: opening.options,
  };
  desk.begin({past: [], present: {design, view: null}, future: []});
}
