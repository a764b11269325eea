/** Drawing of the pattern without tools: the pieces of a workbench in their print. */
import type {PatternView, PatternViewOptions} from '../../viewer/pattern-view.js';
import {SceneDrawing, type OpenView} from './scene-drawing.js';

export class PatternDrawing extends SceneDrawing<PatternView> {
  /** Additional options of a drawing with tools. */
  protected viewOptions(): PatternViewOptions {
    return {};
  }

  protected override async load(): Promise<OpenView<PatternView>> {
    const {PatternView} = await import('../../viewer/pattern-view.js');
    return (stage, options) => new PatternView(stage, {...options, ...this.viewOptions()});
  }
}
