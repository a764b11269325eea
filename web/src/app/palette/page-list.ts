/** All commands of the page, the likeliest first. */
import {languageNames, languages, type Preferences} from '../../texts/preferences.js';
import type {Command} from '../../commands/editor-command.js';
import {garmentCommands, printCommands, solveCommands, stepCommands} from './design-list.js';
import {viewSaves} from '../saves/drape-files.js';
import {repeatSaves} from '../saves/repeat-saves.js';
import {withKey, type PageParts} from './page-parts.js';
import {pieceCommands, toolCommands, viewCommands} from './pattern-list.js';

export const allCommands = (parts: PageParts): readonly Command[] => [
  ...stepCommands(parts),
  ...fileCommands(parts),
  ...savesOfView(parts),
  ...savesOfRepeat(parts),
  ...toolCommands(parts),
  ...viewCommands(parts),
  ...solveCommands(parts),
  ...printCommands(parts),
  ...garmentCommands(parts),
  ...pieceCommands(parts),
  ...settingCommands(parts),
];

/** Commands that save files of the view beside the pattern, if there is one. */
function savesOfView({workbench, texts, editor, saves}: PageParts): readonly Command[] {
  const view = editor.drape ?? editor.marker;
  if (!view) return [];
  const words = texts.commands.also.save;
  const commands = viewSaves(view, workbench, saves.other);
  return commands.map((command) => ({...command, words}));
}

/** Commands that save the repeat of the print. */
function savesOfRepeat({workbench, texts, saves}: PageParts): readonly Command[] {
  if (!workbench.history.design) return [];
  const {lists, repeat, commands} = texts;
  const words = `${commands.also.save} ${commands.also.print}`;
  return repeatSaves(workbench, saves.other).map((command) => ({
    ...{...command, words},
    title: lists.of(repeat.title, command.title),
  }));
}

function fileCommands(parts: PageParts): readonly Command[] {
  const {workbench, texts, saves} = parts;
  const {app, commands, print, projects} = texts;
  const {also, needs} = commands;
  const open: readonly Command[] = [
    withKey(texts, 'open', {words: also.open, run: parts.openGarment}),
    {
      ...{id: 'open print', title: print.open, words: `${also.open} ${also.print}`},
      run: parts.openPrint,
    },
    {id: 'projects', title: projects.title, words: also.open, run: parts.showProjects},
  ];
  if (!workbench.history.design) return open;
  const why = workbench.solving.result ? undefined : needs.answer;
  const saved = (
    id: Exclude<keyof typeof saves, 'other' | 'cut'>,
    title: string,
    words: string,
    why?: string,
  ): Command => ({
    ...{id: `save ${id}`, title, words: `${also.save} ${words}`, why, run: saves[id]},
  });
  return [
    ...open,
    withKey(texts, 'save', {words: also.save, run: saves.project}),
    saved('result', app.saveResult, '', why),
    saved('picture', app.savePicture, also.picture, why),
    withKey(texts, 'cut', {words: `${also.save} ${also.cutting}`, run: saves.cut}),
    saved('link', app.copyLink, also.link),
    {
      ...{id: 'paper', title: commands.paper, words: also.paper},
      run: () => {
        globalThis.print();
      },
    },
  ];
}

function settingCommands({workbench, texts, editor}: PageParts): readonly Command[] {
  const {app, commands, controls, lists} = texts;
  const {language, units, theme, scale} = workbench.preferences.chosen;
  const {settings, help} = commands.also;
  const choice = (label: string, name: string, change: Partial<Preferences>): Command => ({
    ...{id: JSON.stringify(change), title: lists.of(label, name), words: settings},
    run: () => {
      workbench.prefer(change);
    },
  });
  const others = <Value>(all: readonly Value[], present: Value): readonly Value[] =>
    all.filter((one) => one !== present);
  const themes = ['system', 'light', 'dark'] as const;
  const lengths = ['cm', 'inch'] as const;
  const scales = {paper: 'absolute', absolute: 'paper'} as const;
  return [
    ...others(languages, language).map((one) =>
      choice(app.language, languageNames[one], {language: one}),
    ),
    ...others(lengths, units).map((one) =>
      choice(app.units, controls.unitNames[one], {units: one}),
    ),
    ...others(themes, theme).map((one) => choice(app.theme, app.themes[one], {theme: one})),
    {...choice('', '', {scale: scales[scale]}), title: controls.paperScale},
    withKey(texts, 'keys', {
      words: help,
      run: () => {
        editor.toggleKeys();
      },
    }),
  ];
}
