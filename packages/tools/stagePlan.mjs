/**
 * Stages of `npm test` in the order that they are to start in: what each needs, and what may run beside it. Where Chromium
 * is missing it is fetched beside types, lint and unit tests, and is there before the first stage that needs it.
 */
export const stagePlan = /** @satisfies {Record<string, Omit<import('./runStages.mjs').Stage, 'run'>>} */ ({
  chromium: { waits: true },
  types: {},
  lint: {},
  unit: { alone: true },
  build: { needs: ['types'], alone: true },
  packages: { needs: ['build', 'chromium'], alone: true },
  browser: { needs: ['build', 'chromium'], alone: true },
});
