/** Accessibility violations of a page, as found by axe. */
import {readFile} from 'node:fs/promises';
import {createRequire} from 'node:module';

import type {AxeResults, ImpactValue} from 'axe-core';
import type {Page} from 'playwright-core';

const axe = createRequire(import.meta.url).resolve('axe-core/axe.min.js');

/** @returns violations as "rule: element" */
export async function barriers(
  page: Page,
  impacts: readonly ImpactValue[] = ['serious', 'critical'],
): Promise<readonly string[]> {
  await page.evaluate(await readFile(axe, 'utf8'));
  const {violations} = await page.evaluate(() =>
    (
      window as unknown as {
        axe: {run(root: Document, options: object): Promise<AxeResults>};
      }
    ).axe.run(document, {resultTypes: ['violations']}),
  );
  return violations
    .filter(({impact = null}) => impacts.includes(impact))
    .flatMap(({id, nodes}) =>
      nodes.map(({target, failureSummary}) => `${id}: ${target.join(' ')} ${failureSummary ?? ''}`),
    );
}
