import {readFileSync, writeFileSync, existsSync} from 'node:fs';
import {it} from 'vitest';
import {drawPlanSvg} from '@/marker/draw/draw-plan-svg.js';
import {openBrowser} from '../support/browser.js';
const read = (f: string) => JSON.parse(readFileSync(f, 'utf8'));
it('draws', async () => {
  const browser = await openBrowser();
  for (const [g, p] of [['shirt', 'check'], ['tee', 'p6m'], ['hoodie', 'p4m'], ['trousers', 'pmg']]) {
    const plan = read(`/tmp/lay/${g}-plan.json`), result = read(`/tmp/lay/${g}.json`);
    const print = {...read(`public/prints/${p}.json`), tile: readFileSync(`public/prints/${p}.svg`, 'utf8')};
    const t = performance.now();
    const svg = drawPlanSvg(plan, {print, results: [result], title: g, words: {units: g === 'tee' ? 'inch' : 'cm'}});
    console.log(g, performance.now() - t, svg.length);
    writeFileSync(`/tmp/lay/${g}.svg`, svg);
    const page = await browser.newPage({viewport: {width: 1000, height: 1300}, deviceScaleFactor: 2});
    await page.setContent(`<body style="margin:0">${svg}`);
    await page.screenshot({path: `/tmp/lay/${g}.png`, fullPage: true});
    await page.close();
  }
  await browser.close();
}, 120000);
