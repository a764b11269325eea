/** The element in a form: submitted values, validity and reset. */
import {expect, it} from 'vitest';

import {snippetWith} from '../../support/package/embedding.js';
import {caughtUp} from '../../support/page/waiting.js';
import {tee, useElementPage} from '../../support/page/element-page.js';

const openPage = useElementPage();

const inForm = (attributes: string): string =>
  `<form><fieldset>${tee.replace('alt=', `${attributes} alt=`)}</fieldset></form>`;

it('submits its design under its name once there is an answer, and is invalid until then', async () => {
  const {put, run} = await openPage();
  await put(`<div class="far"></div>${inForm('name="design" required')}`); // out of view
  const seen = await run(async (element) => {
    const {form} = element;
    if (!form) throw new Error('It is in no form.');
    const entry = (): unknown => new FormData(form).get('design');
    const early = [
      ...[entry(), element.value, form.checkValidity(), element.validity?.valueMissing],
      ...[element.validationMessage, form.elements.length, element.matches(':invalid')],
    ];
    await element.solve();
    const stored = JSON.stringify(element.getDesign());
    const late = [entry() === stored, element.value === stored, form.checkValidity()];
    element.print = 'prints/cm.json';
    await Promise.resolve();
    late.push(element.value === '', form.checkValidity());
    await element.solve();
    late.push(form.checkValidity(), element.value.includes('cm.json'));
    return {early, late};
  });
  expect(seen.early).toEqual([
    ...[null, '', false, true],
    ...['The print is not matched yet; wait, or choose another one.', 2, true],
  ]);
  expect(seen.late).toEqual([true, true, true, true, false, true, true]);
});

it(
  'is set back with its form, and restored from what a form has kept',
  {tags: ['thorough']},
  async () => {
    const {put, run} = await openPage();
    await put(inForm('name="design"'));
    const seen = await run(async (element) => {
      await element.solve();
      const first = element.value;
      const design = element.getDesign();
      await element.setDesign({
        ...design,
        print: {...design.print, size: {width: 7, height: 7, angleDeg: 90}},
      });
      const second = element.value;
      element.form?.reset();
      await element.solve();
      const again = element.value;
      element.formStateRestoreCallback(second);
      await element.solve();
      return {first, again, changed: first !== second, restored: element.value === second};
    });
    expect(seen.again).toBe(seen.first);
    expect(seen).toMatchObject({changed: true, restored: true});
  },
);

it(
  'says what is wrong with a value that is no design, and stays as it is',
  {tags: ['thorough']},
  async () => {
    const {put, run} = await openPage();
    await put(inForm('name="design"'));
    const seen = await run(async (element) => {
      await element.solve();
      const {value} = element;
      const told = new Promise<string>((resolve) => {
        element.addEventListener('error', ({detail}) => {
          resolve(`${detail.code}: ${detail.message}`);
        });
      });
      element.value = 'nonsense';
      return {told: await told, kept: element.value === value, state: element.state};
    });
    expect(seen.told).toMatch(/^options: design is not JSON; .*\.$/);
    expect(seen).toMatchObject({kept: true, state: 'ready'});
  },
);

it(
  'is out of reach while it or its fieldset is disabled, and submits nothing then',
  {tags: ['thorough']},
  async () => {
    const {put, run} = await openPage();
    await put(inForm('name="design" mode="place"'));
    const seen = await run(async (element) => {
      await element.solve();
      const reach = async (): Promise<unknown[]> => {
        await element.updateComplete;
        const frame = element.shadowRoot?.querySelector<HTMLElement>('.frame');
        const {form} = element;
        return [
          frame?.inert,
          element.matches(':disabled'),
          form && new FormData(form).has('design'),
        ];
      };
      const seen = [await reach()];
      const fieldset = element.closest('fieldset');
      if (fieldset) fieldset.disabled = true;
      seen.push(await reach());
      if (fieldset) fieldset.disabled = false;
      element.disabled = true;
      seen.push(await reach());
      return seen;
    });
    expect(seen).toEqual([
      [false, false, true],
      [true, true, false],
      [true, true, false],
    ]);
  },
);

const documented = snippetWith('html', '<form method="post"');

it(
  'is pointed at by the browser when its form is submitted too early, and begins then',
  {tags: ['thorough']},
  async () => {
    const {put, page, run, asked} = await openPage();
    const early = '<button form="cart">Now</button>';
    await put(`${early}<div class="far"></div>${documented.replace('<form', '<form id="cart"')}`);
    await page.evaluate(() => {
      document.addEventListener('submit', (event) => {
        event.preventDefault();
        const sent = new FormData(event.target as HTMLFormElement).get('design');
        document.title = typeof sent === 'string' ? `sent ${sent}` : 'sent nothing';
      });
    });
    await caughtUp(page);
    expect(asked).toEqual([]);
    const button = page.getByRole('button', {name: 'Now'});
    await button.click();
    expect(await run((element) => document.activeElement === element)).toBe(true);
    expect(await page.title()).not.toMatch(/^sent/);
    await page.locator('seamwise-garment:state(ready)').waitFor();
    await page.evaluate(() => {
      scrollTo(0, 0);
    });
    await button.click();
    await page.waitForFunction(() => document.title.startsWith('sent'));
    expect(await page.title()).toMatch(/^sent \{"format":"seamwise-design\/1"/);
  },
);

it(
  'begins when its form asks whether it is valid, in view or not',
  {tags: ['thorough']},
  async () => {
    const {put, run} = await openPage();
    await put(`<div class="far"></div>${inForm('name="design" required')}`);
    const seen = await run(async (element) => {
      const before = [element.state, element.form?.checkValidity()];
      const answered = new Promise((resolve) => {
        element.addEventListener('solve', resolve);
      });
      await answered;
      return [...before, element.form?.checkValidity()];
    });
    expect(seen).toEqual(['idle', false, true]);
  },
);

it.each(['preview', 'place', 'edit'])(
  'says with mode="%s" why there is nothing to submit while it is in error',
  {tags: ['thorough']},
  async (mode) => {
    const {put, page, run, answer} = await openPage({maySay: /Failed to load resource/});
    await answer('garments/tee-m.json', (route) => route.fulfill({status: 404}));
    const form = inForm(`name="design" required mode="${mode}"`);
    await put(form.replace('</form>', '<button>Buy</button></form>'));
    await page.locator('seamwise-garment:state(error)').waitFor();
    if (mode !== 'preview')
      await page.locator(`sw-${mode === 'edit' ? 'editor' : 'pattern'}`).waitFor();
    await page.getByRole('button', {name: 'Buy'}).click();
    const seen = await run((element) => [
      document.activeElement === element,
      element.validationMessage,
    ]);
    expect(seen).toEqual([true, expect.stringMatching(/tee-m\.json is not there; .*\.$/)]);
  },
);
