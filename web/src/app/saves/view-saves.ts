/**
 * Commands that save files of the view beside the pattern; loaded with the list that shows them.
 */
import {drapeFiles} from '../../editor/drape/drape-files.js';
import {
  toFailure,
  type MarkerPane,
  type Command,
  type Workbench,
  type DrapePane,
} from '../../editor/index.js';

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
          workbench.say({tone: 'error', text: toFailure(error).message});
        },
      );
    },
  }));
