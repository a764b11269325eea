/** The element in a form: what it submits, when it is valid, and how it is set back. */
import {expect, it} from 'vitest';

import {tee, useElementPage} from './element/open.js';

const openPage = useElementPage();

const inForm = (attributes: string): string =>
  `<form><fieldset>${tee.replace('alt=', `${attributes} alt=`)}</fieldset></form>`;

it('submits its design under its name once there is an answer, and is invalid until then', async () => {
  const {put, run} = await openPage();
  await put(inForm('name="design" required'));
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
    ...['The print is not fitted yet; wait until it is, or choose another.', 2, true],
  ]);
  expect(seen.late).toEqual([true, true, true, true, false, true, true]);
});

it('is set back with its form, and restored from what a form has kept', async () => {
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
});

it('says what is wrong with a value that is no design, and stays as it is', async () => {
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
});

it('is out of reach while it or its fieldset is disabled, and submits nothing then', async () => {
  const {put, run} = await openPage();
  await put(inForm('name="design" mode="place"'));
  const seen = await run(async (element) => {
    await element.solve();
    const reach = async (): Promise<unknown[]> => {
      await element.updateComplete;
      const frame = element.shadowRoot?.querySelector<HTMLElement>('.frame');
      const {form} = element;
      return [frame?.inert, element.matches(':disabled'), form && new FormData(form).has('design')];
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
});
