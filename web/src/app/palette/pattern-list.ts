/** Commands for the pattern: tools, pieces, seams and views. */
import {editorViews} from '../../editor/editor.js';
import {patternCommands} from '../../commands/pattern-commands.js';
import {firstOff, groupRows} from '../../workbench/lists/group-rows.js';
import {pieceRows, seamRows} from '../../workbench/lists/rows.js';
import {togglePart} from '../../workbench/tools/keeping.js';
import {turnPiece, withoutPin} from '../../workbench/lists/changed-options.js';
import type {Command} from '../../commands/editor-command.js';
import {withKey, type PageParts} from './page-parts.js';

const tools = ['sew', 'fold', 'piece', 'axis', 'pair', 'move', 'keep', 'grain'] as const;
const zooms = ['fit', 'zoomIn', 'zoomOut', 'zoom'] as const;

const alsoOf = (id: (typeof tools)[number], {also}: PageParts['texts']['commands']): string => {
  if (id === 'sew' || id === 'fold') return also[id];
  if (id === 'keep') return also.keep;
  return id === 'move' ? '' : also.symmetry;
};

export function toolCommands({workbench, texts, editor}: PageParts): readonly Command[] {
  const {pattern} = editor;
  if (!pattern || !workbench.history.design) return [];
  const {commands, symmetry} = texts;
  const list = tools.map((id) =>
    withKey(texts, id, {
      words: alsoOf(id, commands),
      run: () => {
        patternCommands[id](pattern);
        editor.toPattern();
      },
    }),
  );
  if (workbench.solving.found.length === 0) return list;
  const accept: Command = {
    id: 'accept',
    title: symmetry.acceptAll,
    words: commands.also.symmetry,
    run: () => {
      pattern.tools.acceptAll();
    },
  };
  return [...list, accept];
}

/** Returns commands that open hidden views, and the commands of visible ones. */
export const viewCommands = (parts: PageParts): readonly Command[] => {
  const {texts, editor} = parts;
  const words = texts.pattern.views;
  return [
    ...editorViews
      .filter((view) => view !== editor.shows)
      .map((view): Command => ({
        ...{id: `view ${view}`, title: texts.lists.of(words.label, words[view])},
        words: texts.commands.also.view,
        run: () => {
          editor.show(view);
        },
      })),
    ...(editor.shows === 'garment' || editor.shows === 'marker' ? [] : patternViews(parts)),
    ...((editor.drape ?? editor.marker)?.commands ?? []),
  ];
};

function patternViews({workbench, texts, editor: {pattern}}: PageParts): readonly Command[] {
  if (!pattern || !workbench.history.design) return [];
  const {commands, pattern: words} = texts;
  const {view, zoom} = commands.also;
  const why = workbench.solving.result ? undefined : commands.needs.answer;
  const toggle = (id: string, title: string, run: () => void): Command => ({
    ...{id, title, words: view, why, run},
  });
  return [
    withKey(texts, 'clothOnly', {words: view, run: () => patternCommands.clothOnly(pattern)}),
    toggle('wipe', words.wipe, () => {
      pattern.beforeAfter.toggle();
    }),
    toggle('movement', words.movement, () => {
      pattern.toggleMovement();
    }),
    ...zooms.map((id) =>
      withKey(texts, id, {words: zoom, run: () => patternCommands[id](pattern)}),
    ),
    withKey(texts, 'lens', {words: view, run: () => patternCommands.lens(pattern)}),
  ];
}

/** Returns the commands for each piece and seam by name. */
export function pieceCommands({workbench, texts, editor}: PageParts): readonly Command[] {
  const {pattern} = editor;
  const {commands, remedies, keep, lists, symmetry} = texts;
  const {design} = workbench.history;
  const {selected} = workbench.selection;
  if (!pattern || !design) return [];
  const rows = pieceRows(workbench);
  const ofSelected = withKey(texts, 'turn', {
    words: commands.also.turn,
    why: selected?.kind === 'piece' ? undefined : commands.needs.piece,
    run: () => patternCommands.turn(pattern),
  });
  const seams = seamRows(workbench, texts);
  const off = firstOff(groupRows(workbench, texts));
  const toSeam = (seam: number): void => {
    workbench.selection.select({kind: 'seam', seam, side: 'a'});
    editor.toPattern();
  };
  return [
    ofSelected,
    ...(off
      ? [
          {
            id: 'worst',
            title: commands.worst,
            key: '1',
            run: () => {
              toSeam(off.worst);
            },
          },
        ]
      : []),
    ...rows.flatMap(({piece, name, label, kept, pinned}): readonly Command[] => [
      {
        id: `turn ${name}`,
        title: remedies.what.turn(label),
        words: commands.also.turn,
        run: () => turnPiece(workbench, piece),
      },
      {
        id: `keep ${name}`,
        title: lists.of(kept === 'all' ? keep.release : keep.keep, label),
        words: commands.also.keep,
        run: () => {
          togglePart(workbench, {piece});
        },
      },
      ...(pinned
        ? [
            {
              id: `free ${name}`,
              title: symmetry.freePiece(label),
              run: () => {
                workbench.history.change({options: withoutPin(design.options, name)});
              },
            },
          ]
        : []),
      {
        id: `piece ${name}`,
        title: lists.of(lists.piece, label),
        run: () => {
          workbench.selection.select({kind: 'piece', piece});
          editor.toPattern();
        },
      },
    ]),
    ...seams.map(({seam, name}): Command => ({
      id: `seam ${seam}`,
      title: lists.of(lists.seam, name),
      run: () => {
        toSeam(seam);
      },
    })),
  ];
}
