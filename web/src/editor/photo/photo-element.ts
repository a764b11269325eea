/** Base class of the parts of the photo dialog. */
import {photoTexts, type PhotoTexts} from '../../texts/photo-texts.js';
import {WorkbenchElement} from '../base/workbench-element.js';
import type {Said} from './photo-progress.js';
import type {PhotoSession} from '../../workbench/photo/photo-session.js';

export abstract class PhotoElement extends WorkbenchElement {
  static override properties = {...WorkbenchElement.properties, session: {attribute: false}};
  declare session: PhotoSession;

  protected get words(): PhotoTexts {
    const {language, messages} = this.workbench.preferences.chosen;
    return photoTexts(language, messages);
  }

  /** Texts of a progress bar with a button to cancel. */
  protected get said(): Said {
    const {words, format, texts} = this;
    return {words, cancel: texts.app.cancel, percent: (share) => format.percent(share)};
  }
}
