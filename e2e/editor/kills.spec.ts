import { byExtent } from '@farol/tools/extent';
import { killModes, killTab, MOST_LOST } from '@farol/tools/soakKills';
import { random } from '../pages/random';
import { expect, test } from '../support/test';

test.use({ viewport: { width: 900, height: 560 }, reducedMotion: 'reduce' });

// one kind of edit in the slice; many more by hand: npm run soak -- --minutes 0 --kills 50
test('a tab that is killed while edits go on loses nothing that was stored, and its draft is offered @verify', async ({
  context,
}) => {
  // how long edits go on: as short as may be in the slice
  const next = byExtent({ slice: () => 0, verify: random(13) });
  // the last second at most: npm run soak asks it too
  const asksTime = byExtent({ slice: false, verify: false, long: true });
  const lines: string[] = [];
  for (const mode of byExtent<readonly (typeof killModes)[number][]>({ slice: ['objects'], verify: killModes })) {
    const kill = await killTab(context, { url: process.env.FAROL_EDITOR_URL!, random: next, mode });
    lines.push(
      `${mode}: ${kill.lost} of ${kill.edits} edits lost, up to ${kill.stored} were stored, the oldest of ${kill.lostMs} ms`,
    );
    expect(kill.edits, mode).toBeGreaterThan(5);
    expect(kill.offered, `${mode}: offered`).toBe(true);
    expect(kill.stored, `${mode}: the last edit in a draft`).toBeGreaterThan(0);
    expect(kill.kept, `${mode}: the last edit that is there`).toBeGreaterThanOrEqual(kill.stored);
    if (asksTime) expect(kill.lostMs, lines.at(-1)).toBeLessThanOrEqual(MOST_LOST + kill.stallMs);
  }
  console.log(`Killed while editing: ${lines.join('; ')}.`);
});
