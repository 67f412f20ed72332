import { availableParallelism } from 'node:os';
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vitest/config';
import { countSteps } from './tools/countSteps.mjs';
import { isWhole } from './tools/extent.mjs';
import { otherThree } from './tools/otherThree.mjs';
import { serverSourceConditions } from './tools/sourceConditions.mjs';

const include = [
  'packages/*/**/*.test.ts',
  'apps/*/src/**/*.test.{ts,tsx}',
  'apps/site/live/**/*.test.ts',
  'apps/lab/rivals/src/**/*.test.ts',
  'e2e/samples/*.test.ts',
  'e2e/support/*.test.ts',
  'e2e/pages/chance/*.test.ts',
];
const exclude = ['**/node_modules/**', '**/dist/**'];
/** Files that replace modules, or need modules that nothing has used before. */
const alone = [
  'packages/engine/src/app/App.test.ts',
  'packages/engine/src/app/appSize.test.ts',
  'packages/engine/src/components/Decal.test.ts',
  'packages/engine/src/picture/PictureRenderer.test.ts',
  'packages/tools/sourceFiles.test.ts',
];
/** Files that measure the memory of the process: two threads of tests in one would be measured together. */
const processes = ['packages/tools/fuzz/*.test.ts'];
/** Files that count the steps of our sources: see tools/workOf.mjs. */
const counted = ['packages/**/*.work.test.ts', 'apps/*/src/**/*.work.test.ts'];
/** Files that only time, or the processor's work, can tell of: they run with FAROL_TESTS=verify. */
const verify = ['packages/**/*.verify.test.ts', 'apps/*/src/**/*.verify.test.ts'];

/** One run over the unit tests of all workspaces, in Node; with the three of the folder FAROL_THREE, if there is one. */
export default defineConfig({
  root: fileURLToPath(new URL('..', import.meta.url)),
  ssr: { resolve: { conditions: serverSourceConditions } },
  plugins: process.env.FAROL_THREE ? [otherThree(process.env.FAROL_THREE)] : [],
  test: {
    environment: 'node',
    // a process for each file costs more than a thread for each
    pool: 'threads',
    maxWorkers: availableParallelism(),
    passWithNoTests: false,
    setupFiles: 'packages/tools/settleImports.mjs',
    // they end what hangs: no test fails for being slow on a busy machine
    testTimeout: 120_000,
    hookTimeout: 120_000,
    projects: [
      // most of the time would go to loading three and our packages anew for each file
      {
        extends: true,
        test: {
          name: 'together',
          include,
          exclude: [...exclude, ...alone, ...processes, ...counted, ...verify],
          isolate: false,
        },
      },
      { extends: true, test: { name: 'alone', include: alone, exclude, isolate: true } },
      {
        extends: true,
        test: { name: 'processes', include: processes, exclude: [...exclude, ...verify], pool: 'forks' },
      },
      {
        extends: true,
        plugins: [countSteps()],
        test: { name: 'counted', include: counted, exclude, isolate: false, setupFiles: 'packages/tools/workOf.mjs' },
      },
      ...(isWhole
        ? [{ extends: true, test: { name: 'verify', include: verify, exclude, pool: 'forks' } } as const]
        : []),
    ],
  },
});
