import js from '@eslint/js';
import {defineConfig, globalIgnores} from 'eslint/config';
import globals from 'globals';
import ts from 'typescript-eslint';

const noRaces = [
  {
    selector:
      'CallExpression:matches([callee.name=/^(it|test|describe)$/], ' +
      '[callee.callee.object.name=/^(it|test|describe)$/], [callee.property.name="setConfig"]) > ' +
      'ObjectExpression > Property[key.name=/^(retry|repeats)$/]',
    message: 'A test passes at the first try; mend what makes it fail.',
  },
  {
    selector: 'CallExpression[callee.property.name="waitForTimeout"]',
    message:
      'Wait for a state of the page or for frames, not for a time; see tests/support/page/waiting.ts.',
  },
  {
    selector:
      ':matches(CallExpression[callee.name="expect"], CallExpression[callee.object.callee.name="expect"]) ' +
      'CallExpression[callee.object.name=/^(performance|Date)$/][callee.property.name="now"]',
    message: 'Check times in tests/timing, where nothing else runs.',
  },
];
const noBareReads = {
  selector:
    'CallExpression[callee.name="expect"] > AwaitExpression > ' +
    'CallExpression[callee.property.name=/^(count|allTextContents|allInnerTexts|evaluateAll)$/]',
  message: 'A list may not be drawn yet; poll it with expect.poll.',
};

export default defineConfig(
  globalIgnores(['build/', 'dist/', 'out/', 'web/src/solver/module/*.mjs']),
  js.configs.recommended,
  {files: ['**/*.{js,mjs}'], languageOptions: {globals: globals.node}},
  {files: ['web/examples/**/*.js'], languageOptions: {globals: globals.browser}},
  {
    files: ['**/*.ts', '**/*.mts'],
    extends: [ts.configs.strictTypeChecked, ts.configs.stylisticTypeChecked],
    languageOptions: {parserOptions: {projectService: true}},
    rules: {
      '@typescript-eslint/restrict-template-expressions': ['error', {allowNumber: true}],
      '@typescript-eslint/consistent-type-definitions': 'off',
    },
  },
  {
    files: ['tests/**/*.ts'],
    ignores: ['tests/{timing,bench}/**'],
    rules: {'no-restricted-syntax': ['error', ...noRaces]},
  },
  {
    files: ['tests/{page,support/page}/**/*.ts'],
    rules: {'no-restricted-syntax': ['error', ...noRaces, noBareReads]},
  },
);
