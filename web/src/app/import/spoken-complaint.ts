/** Reasons why a file is no pattern, in the user's language; the readers write them in English. */
import type {ImportTexts} from '../../texts/import-texts.js';

type Complaint = keyof ImportTexts['complaints'];

/** Beginnings of the readers' sentences after the name of the file. */
const beginnings: readonly (readonly [string, Complaint])[] = [
  ['is no pattern that can be read', 'unreadable'],
  ['is empty', 'empty'],
  ['has no closed outline', 'outline'],
  ['shows no closed line', 'outline'],
  ['is damaged', 'damaged'],
  ['is an archive', 'archive'],
  ['is compressed', 'archive'],
  ['is a binary DXF', 'binary'],
  ['is DWG', 'binary'],
  ["is Adobe Illustrator's own format", 'illustrator'],
  ['is a 3D model', 'model'],
  ['has no texture coordinates', 'model'],
  ['is a file for plotters', 'plotter'],
  ['is a web page', 'webPage'],
  ['is a pattern of Valentina or Seamly2D', 'valentina'],
];

/** @param message of a reader; it begins with the file's name */
export function spokenComplaint(message: string, file: string, words: ImportTexts): string {
  const said = message.startsWith(`${file} `) ? message.slice(file.length + 1) : '';
  const [, complaint] = beginnings.find(([beginning]) => said.startsWith(beginning)) ?? [];
  return complaint === undefined ? words.failed(message) : words.complaints[complaint](file);
}
