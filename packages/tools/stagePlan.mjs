/**
 * Stages of `npm test` in the order that they are to start in: what each needs, and what may run beside it. On a small machine
 * the browser tests alone keep all cores busy; the others wait for files and processes at times, and run side by side. Where
 * Chromium is missing it is fetched beside them, and is there before the first stage that needs it.
 */
export const stagePlan = /** @satisfies {Record<string, Omit<import('./runStages.mjs').Stage, 'run'>>} */ ({
  chromium: { waits: true },
  types: {},
  lint: {},
  unit: {},
  build: { needs: ['types'] },
  packages: { needs: ['build', 'chromium'] },
  browser: { needs: ['build', 'chromium'], alone: true },
});
