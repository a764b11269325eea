/** Commands that save the repeat of the print for a print shop. */
import type {Command} from '../../commands/editor-command.js';
import {spokenFailure} from '../../workbench/spoken-failure.js';
import {textsOf} from '../../texts/texts.js';
import {toFailure} from '../../workbench/latest-solve.js';
import {repeatFile, repeatKinds, type RepeatKind} from '../../workbench/print/repeat-file.js';
import type {Workbench} from '../../workbench/workbench.js';

/** @param save receives the ending of the file's name and the content */
export function repeatSaves(
  workbench: Workbench,
  save: (ending: string, content: Blob) => void,
): readonly Command[] {
  const {language, messages} = workbench.preferences.chosen;
  const texts = textsOf(language, messages);
  const {repeat: words} = texts;
  const run = async (kind: RepeatKind): Promise<void> => {
    const {design} = workbench.history;
    if (!design) return;
    try {
      const {content, ending, note} = await repeatFile(design.print, kind, words);
      save(ending, content);
      if (note !== undefined) workbench.notices.say({tone: 'info', text: note});
    } catch (error) {
      const text = spokenFailure(toFailure(error), workbench, texts);
      workbench.notices.say({tone: 'error', text});
    }
  };
  return repeatKinds.map((kind) => ({
    ...{id: `save repeat ${kind}`, title: kind === 'svg' ? 'SVG' : words.png(String(kind))},
    run: () => void run(kind),
  }));
}
