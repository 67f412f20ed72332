/**
 * `npm run fuzz`: opens 100,000 generated and damaged files; see packages/engine/src/fuzz. Failing ones are cut down and
 * written to .cache/fuzz: mend the fault, and keep the file in packages/engine/src/fuzz/found.
 *
 * `npm run fuzz -- 5000 77` opens 5,000, the first of seed 77.
 */
import { join } from 'node:path';
import { root } from './root.mjs';
import { runTool } from './runTool.mjs';

const [cases = '100000', seed = '1000000'] = process.argv.slice(2);
process.exitCode = runTool(
  'vitest',
  'vitest',
  ['run', '--config', 'packages/vitest.config.ts', 'packages/engine/src/fuzz'],
  { FAROL_FUZZ_CASES: cases, FAROL_FUZZ_SEED: seed, FAROL_FUZZ_OUT: join(root, '.cache/fuzz') },
);
