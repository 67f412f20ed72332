import type { TechniqueName } from '@farol/renderer';
import type { EffectName } from '@farol/renderer/effects';
import { expect, test } from '../support/test';

/**
 * Losses of the context: after each the picture is the same to the bit, without a message but of the loss itself, and with
 * no GPU object more. `npm test` loses one by a few techniques; `npm run losses` a hundred by each technique and effect.
 */
const LOSSES = Number(process.env.FAROL_LOSSES ?? 1);
const WHOLE = LOSSES > 1;
const LOST = /a WebGL context was lost|Context Lost|Context Restored/i;

const EFFECTS: readonly EffectName[] = ['decals', 'ambient-occlusion', 'order-independent-transparency'];
/** Of each technique once with what smooths edges. */
const CASES: readonly (readonly [TechniqueName, readonly EffectName[]])[] = [
  ['deferred', [...EFFECTS, 'taa']],
  ['forward', ['order-independent-transparency', 'edges']],
  ['inferred', ['smaa']],
];
const OTHERS: typeof CASES = [
  ['tiled-deferred', [...EFFECTS, 'smaa']],
  ['forward-plus', ['ambient-occlusion', 'taa']],
  ['auto', []],
  ['forward-single-pass', ['taa']],
  ['light-prepass', ['ambient-occlusion', 'edges']],
  ['tiled-forward', ['edges']],
  ['clustered-deferred', [...EFFECTS, 'edges']],
  ['clustered-forward', ['smaa']],
];

for (const [technique, effects] of WHOLE ? [...CASES, ...OTHERS] : CASES) {
  test(`${technique}, ${effects.join(', ')}: as before after each loss of the context`, async ({
    page,
    pagesURL,
    watch,
  }) => {
    test.setTimeout(60_000 + 30_000 * LOSSES);
    await page.goto(pagesURL);
    await page.waitForFunction(() => 'testPage' in window);
    const { changed, before, after, memory } = await page.evaluate(
      ([technique, losses, effects]) => window.testPage.loseContexts(technique, losses, effects),
      [technique, LOSSES, effects] as const,
    );
    expect(watch.forgive(LOST)).toBeGreaterThanOrEqual(LOSSES);
    expect(changed, 'losses after which the picture is another').toEqual([]);
    expect(after).toEqual(before);
    expect(memory[1]).toEqual(memory[0]);
  });
}
