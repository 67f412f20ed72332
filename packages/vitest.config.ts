import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vitest/config';

/** One run over the unit tests of all workspaces, in Node. */
export default defineConfig({
  root: fileURLToPath(new URL('..', import.meta.url)),
  test: {
    include: ['packages/*/**/*.test.ts', 'apps/*/src/**/*.test.{ts,tsx}', 'e2e/support/*.test.ts'],
    exclude: ['**/node_modules/**', '**/dist/**'],
    environment: 'node',
    // a process for each file costs more than a thread for each
    pool: 'threads',
    passWithNoTests: false,
    // a scene is made in about two seconds, on a machine that does other things in ten
    testTimeout: 30_000,
    hookTimeout: 30_000,
  },
});
