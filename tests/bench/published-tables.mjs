// Results of the published method, as published and at its best, compared with those of `best`.
import {median, quotient} from './numbers.mjs';
import {fit, millimetres, ms, share, table} from './table.mjs';

/** Quotients by name; null where both mismatches are zero. */
const ratios = {
  'best/paper': ({best, paper}) => quotient(best.fit, paper.fit),
  'best/best paper': ({best, bestPaper}) => quotient(best.fit, bestPaper.fit),
  'best/random': ({best}) => best.fit / best.fitRandom,
  'best/drafted': ({best}) => quotient(best.fit, best.fitDrafted),
  'best paper/drafted': ({best, bestPaper}) => quotient(bestPaper.fit, best.fitDrafted),
};
const names = Object.keys(ratios);

const caseHead = [
  'garment, group',
  'random',
  'drafted',
  'paper',
  'best paper',
  'best',
  ...names,
  'best paper off cm',
  'best off cm',
  'best paper p90 mm',
  'best p90 mm',
  'paper ms',
  'best ms',
];

const caseRow = (row) => {
  const {garment, group, best, paper, bestPaper} = row;
  return [
    `${garment}, ${group}`,
    ...[best.fitRandom, best.fitDrafted, paper.fit, bestPaper.fit, best.fit].map(fit),
    ...names.map((name) => share(ratios[name](row))),
    ...[bestPaper, best].map(({off}) => off.toFixed(0)),
    ...[bestPaper, best].map(({p90}) => millimetres(p90)),
    ...[paper, best].map(({milliseconds}) => ms(milliseconds.total)),
  ];
};

/** Row of the medians of some cases. */
function middleRow(name, rows) {
  const middle = (values) => {
    const numbers = values.filter((value) => value !== null);
    return numbers.length > 0 ? median(numbers) : null;
  };
  return [name, rows.length, ...names.map((ratio) => share(middle(rows.map(ratios[ratio]))))];
}

/** Medians by group and over all, then every case. */
export function publishedTables(rows) {
  const groups = [...new Set(rows.map(({group}) => group))];
  const middles = [
    ...groups.map((group) =>
      middleRow(
        group,
        rows.filter((row) => row.group === group),
      ),
    ),
    middleRow('all', rows),
  ];
  return [
    table(['median of', 'cases', ...names], middles),
    table(caseHead, rows.map(caseRow)),
  ].join('\n\n');
}
