/** What there is to take away of a worn garment, as commands: loaded with a list of them. */
import {toFailure, type Command, type Workbench, type WornPane} from '../../editor/index.js';
import {wornFiles} from '../../editor/worn/worn-files.js';

/** @param save gets what is to be saved, and how the name of its file ends */
export const wornSaves = (
  worn: WornPane,
  workbench: Workbench,
  save: (ending: string, content: Blob) => void,
): readonly Command[] =>
  wornFiles(worn).map(({id, title, ending, make}) => ({
    ...{id: `save worn ${id}`, title},
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
