/**
 * Writes docs/prints.svg, the contact sheet of the collection, and docs/groups.svg, the figure of
 * the 17 groups.
 */
import {writeFileSync} from 'node:fs';

import {collection} from './collection.js';
import {groupsFigure} from './groups-figure.js';
import {contactSheet} from './sheet.js';

writeFileSync('docs/prints.svg', await contactSheet(collection));
writeFileSync('docs/groups.svg', groupsFigure());
