/**
 * Commands that save files of the view beside the pattern; loaded with the list that shows them.
 */
import {drapeFiles} from './drape-files.js';
import {toFailure} from '../../workbench/latest-solve.js';
import type {MarkerPane} from '../../editor/marker/marker-pane.js';
import type {Command} from '../../commands/editor-command.js';
import type {Workbench} from '../../workbench/workbench.js';
import type {DrapePane} from '../../editor/drape/drape-pane.js';

/** @param save receives the content and the ending of the file's name */
export const viewSaves = (
  view: DrapePane | MarkerPane,
  workbench: Workbench,
  save: (ending: string, content: Blob) => void,
): readonly Command[] =>
  ('files' in view ? view.files : drapeFiles(view)).map(({id, title, ending, make}) => ({
    ...{id: `save view ${id}`, title},
    run: () => {
      make().then(
        (content) => {
          save(ending, content);
        },
        (error: unknown) => {
          workbench.notices.say({tone: 'error', text: toFailure(error).message});
        },
      );
    },
  }));
