/**
 * `npm run try [files]`: the loop of a developer. Formats and lints what changed since the last commit (or the files that
 * are named, or the last commit where nothing changed), checks types, and runs the unit tests and browser tests of its
 * subject, from source.
 */
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { changedFiles } from './changedFiles.mjs';
import { ensureBrowser } from './ensureBrowser.mjs';
import { ensureInstalled } from './ensureInstalled.mjs';
import { root } from './root.mjs';
import { runStages } from './runStages.mjs';
import { specsOf } from './subjects.mjs';
import { startTool } from './startTool.mjs';

ensureInstalled();
const named = process.argv.slice(2).map((path) => path.replaceAll('\\', '/').replace(/^\.\//, ''));
const missing = named.filter((path) => !existsSync(join(root, path)));
if (missing.length > 0) {
  console.error(`No file ${missing.join(', ')}: paths go from the top of the repository.`);
  process.exit(1);
}
const changed = named.length > 0 ? named : changedFiles();
const formatted = changed.filter((path) => /\.(tsx?|mjs|css|json|md|html)$/.test(path));
const linted = changed.filter((path) => /\.(tsx?|mjs)$/.test(path));
const specs = [...new Set(changed.flatMap((path) => [...specsOf(path)]))];
console.log(`Changed:\n  ${changed.join('\n  ')}\nBrowser tests:\n  ${specs.join('\n  ') || 'none'}`);

/** @type {Record<string, number>} */
const begun = {};
const outcomes = await runStages(
  {
    lint: {
      run: async () =>
        (formatted.length === 0 || (await startTool('oxfmt', 'oxfmt', formatted)) === 0) &&
        (linted.length === 0 || (await startTool('oxlint', 'oxlint', linted)) === 0),
    },
    types: { run: async () => (await startTool('typescript', 'tsc', ['-b', 'packages'], { isHeld: true })) === 0 },
    unit: {
      run: async () => {
        const { relatedTests } = await import('./relatedTests.mjs');
        const { importGraph } = await import('./importCircles.mjs');
        const { sourceFiles } = await import('./sourceFiles.mjs');
        const files = sourceFiles();
        const tests = relatedTests(changed, files, importGraph(files));
        return (await startTool('vitest', 'vitest', ['run', '--config', 'packages/vitest.config.ts', ...tests])) === 0;
      },
    },
    browser: {
      run: async () => {
        if (specs.length === 0) return true;
        const args = ['test', '--config', 'e2e/playwright.config.ts', ...specs];
        return (
          (await startTool('@playwright/test', 'playwright', args, { env: { CHROMIUM_PATH: ensureBrowser() } })) === 0
        );
      },
    },
  },
  {
    isSmall: false,
    onStart: (name) => (begun[name] = performance.now()),
    onEnd: (name, outcome) =>
      console.log(`== ${name} ${outcome} in ${((performance.now() - begun[name]) / 1000).toFixed(1)} s`),
  },
);
process.exit(Object.values(outcomes).every((outcome) => outcome === 'passed') ? 0 : 1);
