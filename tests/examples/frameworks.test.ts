/**
 * Frameworks with a server or a compiler of their own, set up by the words of docs/frameworks.md.
 * They are installed from the registry; without it the tests are left out.
 */
import {spawn} from 'node:child_process';
import {once} from 'node:events';
import {join} from 'node:path';

import {expect, it, onTestFinished} from 'vitest';

import {guide, inShell, isOnline, ownFiles, useProjects} from '../support/package/projects.js';

const {projectWith, works, worksAt} = useProjects();

/** The code example in this language under a heading of the guide, with an element that starts at once. */
function snippet(heading: string, language: string): string {
  const part = guide.split(/^## /m).find((one) => one.startsWith(`${heading}\n`)) ?? '';
  const code = new RegExp(`^\`\`\`${language}\\n([^]*?)^\`\`\`$`, 'm').exec(part)?.[1];
  expect(code, `${heading}, ${language}`).toBeDefined();
  return (code ?? '').replace('<seamwise-garment', '<seamwise-garment loading="eager"');
}

/** Inline scripts and styles of these frameworks start their pages. */
const withInline = `${ownFiles} 'unsafe-inline'`;
const icon = '<link rel="icon" href="/icon.svg" />';

it.runIf(isOnline)('works with SvelteKit by the guide', async () => {
  const kit = ['@sveltejs/kit', '@sveltejs/adapter-static', '@sveltejs/vite-plugin-svelte'];
  const folder = await projectWith(
    ['svelte', 'vite@8', ...kit],
    {
      'vite.config.js':
        "import {sveltekit} from '@sveltejs/kit/vite';\nexport default {plugins: [sveltekit()]};\n",
      'svelte.config.js':
        "import adapter from '@sveltejs/adapter-static';\nexport default {kit: {adapter: adapter()}};\n",
      'src/app.html': `<!doctype html><html lang="en"><head>${icon}%sveltekit.head%</head><body>%sveltekit.body%</body></html>`,
      'src/routes/+layout.js': 'export const prerender = true;\n',
      'src/routes/+page.svelte': snippet('SvelteKit', 'svelte'),
    },
    ['static'],
  );
  await inShell(folder, 'npx vite build');
  await works(join(folder, 'build'), withInline);
});

it.runIf(isOnline)('works with Astro by the guide', async () => {
  const [, setting = ''] = /Astro up to 5 needs `([^`]*)`/.exec(guide) ?? [];
  const folder = await projectWith(
    ['astro@5'],
    {
      'astro.config.mjs': `export default {${setting}};\n`,
      'src/pages/index.astro': `---\n---\n${icon}\n${snippet('Astro', 'astro')}`,
    },
    ['public'],
  );
  await inShell(folder, 'npx astro build');
  await works(join(folder, 'dist'), withInline);
});

it.runIf(isOnline)('works with Nuxt by the guide', async () => {
  const folder = await projectWith(
    ['nuxt@4', 'vue'],
    {'nuxt.config.js': snippet('Nuxt', 'js'), 'app/app.vue': snippet('Vue', 'html')},
    ['public'],
  );
  await inShell(folder, 'npx nuxt build');
  const server = spawn(process.execPath, ['.output/server/index.mjs'], {
    cwd: folder,
    env: {...process.env, PORT: '0', NODE_ENV: undefined},
    stdio: ['ignore', 'pipe', 'inherit'],
  });
  onTestFinished(() => {
    server.kill();
  });
  const [said] = (await once(server.stdout, 'data')) as [Buffer];
  const [, port = ''] = /:(\d+)/.exec(said.toString().replace('[::]', '')) ?? [];
  await worksAt(`http://localhost:${port}/`, /status of 404/); // the page has no icon
});
