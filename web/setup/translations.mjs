import {readdirSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';

/** The address of a JSON module and the attributes after it, as TypeScript writes them. */
const importOfJson =
  /['"](\.[^'"\n]+)\.json['"](?: with \{ type: 'json' \}|, \{ with: \{ type: 'json' \} \})/g;

/**
 * Turns the translations of a compiled folder into scripts, since Node 20 warns of JSON modules and
 * older bundlers reject them.
 */
export function scriptTranslations(folder) {
  for (const entry of readdirSync(folder, {recursive: true, withFileTypes: true})) {
    const file = join(entry.parentPath, entry.name);
    if (file.endsWith('.json')) {
      const texts = JSON.stringify(JSON.parse(readFileSync(file, 'utf8')));
      writeFileSync(file.replace(/json$/, 'js'), `export default ${texts};\n`);
      rmSync(file);
    } else if (file.endsWith('.js')) {
      const source = readFileSync(file, 'utf8');
      writeFileSync(file, source.replaceAll(importOfJson, "'$1.js'"));
    }
  }
}
