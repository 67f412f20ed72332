import { readFileSync } from 'node:fs';

const QUERY = '?run-info';

/**
 * Vite plugin: `import info from './run.json?run-info'` gives a summary of a run of the Lab (`RunInfo` of apps/lab), so
 * that a list of runs need not fetch the runs themselves.
 *
 * @returns {import('vite').Plugin}
 */
export function runInfo() {
  return {
    name: 'farol-run-info',
    enforce: 'pre',
    load(id) {
      if (!id.endsWith(QUERY)) return null;
      const run = JSON.parse(readFileSync(id.slice(0, -QUERY.length), 'utf8'));
      const { date, device, browser, build } = run.surroundings;
      const { id: runId, name, plan, complete, rows } = run;
      const info = { id: runId, name, label: plan.label, date, device, browser, build, complete, rows: rows.length };
      return { code: `export default ${JSON.stringify(info)};`, moduleType: 'js' };
    },
  };
}
