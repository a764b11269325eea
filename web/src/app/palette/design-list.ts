/** Commands that change the design: undo and redo, solver settings, garment and print. */
import {canAlign} from '../../workbench/can-align.js';
import {
  solveSettingsOf,
  presetNames,
  presetOf,
  withSolveSettings,
  withPreset,
} from '../../workbench/presets.js';
import {inColours, samplePrint} from '../../workbench/samples.js';
import {takePrint} from '../../workbench/print/take-print.js';
import {redoWords, undoWords} from '../../workbench/history/step-change.js';
import {remedied, remedyWords} from '../../workbench/remedies/remedied.js';
import type {Command} from '../../commands/editor-command.js';
import {withKey, type PageParts} from './page-parts.js';

const grains = ['on', 'across', 'bias', 'free'] as const;

export function stepCommands({workbench, texts}: PageParts): readonly Command[] {
  const {app} = texts;
  const [undone, redone] = [undoWords(workbench, texts), redoWords(workbench, texts)];
  const undo = (): void => {
    workbench.history.undo();
  };
  const redo = (): void => {
    workbench.history.redo();
  };
  return [
    ...(undone === undefined
      ? []
      : [withKey(texts, 'undo', {title: app.undoOf(undone), run: undo})]),
    ...(redone === undefined
      ? []
      : [withKey(texts, 'redo', {title: app.redoOf(redone), run: redo})]),
  ];
}

export function solveCommands({workbench, texts, format, samples}: PageParts): readonly Command[] {
  const {app, commands, controls, longer} = texts;
  const {design} = workbench.history;
  const {state} = workbench.solving;
  const preferences = workbench.preferences.chosen;
  if (!design) return [];
  const {solve} = commands.also;
  const list: Command[] = [];
  const add = (id: string, title: string, words: string, run: () => void): void => {
    list.push({id, title, words, run});
  };
  if (canAlign(workbench)) {
    add('align', app.align, solve, () => {
      workbench.solving.align();
    });
  }
  if (state.kind === 'solving') {
    add('cancel', app.cancel, solve, () => {
      workbench.solving.cancel();
    });
  }
  const {result} = workbench.solving;
  const {afterwards, searches} = workbench;
  if (searches.isRunning('longer', design)) {
    add('end longer search', longer.end, commands.also.longer, () => {
      searches.end('longer', design);
    });
  } else if (result && state.kind === 'done' && design.method === 'best') {
    add('longer search', longer.begin, commands.also.longer, () => {
      void afterwards.search('longer', design, result);
    });
  }
  for (const [k, remedy] of (result ? afterwards.remedies(design) : []).entries()) {
    const change = remedied(design, remedy, samples);
    if (!change) continue;
    add(`remedy ${k}`, remedyWords(remedy, workbench, texts, format), '', () => {
      workbench.history.change(change);
    });
  }
  add('solve as I go', controls.solveAsIGo, solve, () => {
    workbench.prefer({solveAsIGo: !preferences.solveAsIGo});
  });
  for (const name of presetNames) {
    if (name === presetOf(design)) continue;
    const words = name === 'placeOnly' ? commands.also.placeOnly : controls.presets;
    add(`preset ${name}`, controls.presetNames[name], words, () => {
      workbench.history.change(withPreset(design, name));
    });
  }
  const settings = solveSettingsOf(design);
  for (const grain of grains) {
    if (grain === settings.grain) continue;
    add(`grain ${grain}`, texts.lists.of(controls.grain, controls.grains[grain]), '', () => {
      workbench.history.change(withSolveSettings(design, {...settings, grain}));
    });
  }
  return list;
}

export function printCommands({workbench, texts, samples}: PageParts): readonly Command[] {
  const {design} = workbench.history;
  if (!design || !samples) return [];
  const {print, commands, lists, samples: named} = texts;
  const titleOf = (name: string, title: string): string => named.prints[name] ?? title;
  const worn = samples.prints.find(({name}) => name === design.print.sample?.name);
  return [
    ...samples.prints.map((sample): Command => {
      const {name, title, group} = sample;
      return {
        id: `print ${name}`,
        title: lists.of(print.print, titleOf(name, title)),
        words: `${group} ${commands.also.print}`,
        run: () => {
          takePrint(workbench, samplePrint(sample));
        },
      };
    }),
    ...(worn?.colourways ?? []).map(({name}): Command => ({
      id: `colours ${name}`,
      title: lists.of(print.colourways, named.colourways[name] ?? name),
      words: titleOf(worn?.name ?? '', worn?.title ?? ''),
      run: () => {
        if (worn) workbench.history.change({print: inColours(design.print, worn, name)});
      },
    })),
  ];
}

export function garmentCommands({
  workbench,
  texts,
  samples,
  garments,
}: PageParts): readonly Command[] {
  if (!samples) return [];
  const {app, commands, lists, samples: named} = texts;
  const {style: shown, size: worn = 'm'} = workbench.history.design?.garment.sample ?? {};
  const sizes = samples.garments.find(({style}) => style === shown)?.sizes ?? [];
  return [
    ...samples.garments.map(({style, title}): Command => ({
      id: `garment ${style}`,
      title: lists.of(app.garment, named.garments[style] ?? title),
      words: `${title} ${commands.also.garment}`,
      run: () => void garments.choose(style, worn),
    })),
    ...sizes.map((size): Command => ({
      id: `size ${size}`,
      title: lists.of(app.size, size.toUpperCase()),
      run: () => {
        if (shown !== undefined) void garments.choose(shown, size);
      },
    })),
  ];
}
