/** Opens whatever a user hands over: a garment, a print, a project, a result. */
import {toFailure, type Workbench} from '../element/index.js';

/** What cannot be opened is said, and leaves everything as it is. */
export async function openFile(desk: Workbench, file: File): Promise<void> {
  try {
    await desk.open({name: file.name, text: await file.text()});
  } catch (error) {
    desk.say({tone: 'error', text: toFailure(error).message});
  }
}
